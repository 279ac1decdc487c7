// What a caller describes a scene with: meshes, the camera, lights; and the public enumerations.
#include <pybind11/native_enum.h>

#include "bindings/arrays.h"
#include "bindings/bind.h"
#include "bindings/names.h"
#include "contour/network/curve_network.h"
#include "mesh/instance.h"
#include "tone/light.h"
#include "view/camera.h"

namespace illustrate::bindings {
namespace {

void bind_enumerations(py::module_& m) {
  py::native_enum<Kind>(m, "Kind", "enum.IntEnum", "What a curve is.")
      .value("SILHOUETTE", Kind::silhouette)
      .value("BOUNDARY", Kind::boundary)
      .value("CREASE", Kind::crease)
      .value("INTERSECTION", Kind::intersection)
      .value("HATCH", Kind::hatch)
      .value("CROSS_HATCH", Kind::cross_hatch)
      .value("UNDERCUT", Kind::undercut)
      .value("MARK", Kind::mark)
      .value("MATERIAL", Kind::material)
      .value("FLAT_OUTLINE", Kind::flat_outline)
      .value("SEAM", Kind::seam)
      .value("SUGGESTIVE", Kind::suggestive)
      .value("RIDGE", Kind::ridge)
      .value("VALLEY", Kind::valley)
      .value("LOOSE", Kind::loose)
      .value("TERMINATOR", Kind::terminator)
      .value("SHADOW_OUTLINE", Kind::shadow_outline)
      .finalize();
  py::native_enum<NodeKind>(m, "Node", "enum.IntEnum", "What a node of the curve network is.")
      .value("CUSP", NodeKind::cusp)
      .value("CROSSING", NodeKind::crossing)
      .value("JOINT", NodeKind::joint)
      .value("END", NodeKind::end)
      .finalize();
}

BoundaryRule boundary_named(const std::string& name) {
  if (name == "corners") return BoundaryRule::corners;
  if (name == "edges") return BoundaryRule::edges;
  throw InvalidInput("boundary is '" + name + "', expected 'corners' or 'edges'");
}

template <class Value, class Read>
void read_if_given(const py::object& argument, const char* name, Value& value, Read read) {
  if (!argument.is_none()) value = read(argument, name);
}

constexpr std::array<const char*, 4> wrap_names{"repeat", "mirror", "extend", "clip"};

Wrap wrap_named(const std::string& name) {
  for (std::size_t i = 0; i < wrap_names.size(); ++i) {
    if (name == wrap_names[i]) return static_cast<Wrap>(i);
  }
  throw InvalidInput("wrap is '" + name + "', expected 'repeat', 'mirror', 'extend' or 'clip'");
}

std::shared_ptr<Texture> make_texture(const py::object& luminance, const std::string& wrap) {
  using Rows = py::array_t<float, py::array::c_style | py::array::forcecast>;
  const Rows rows = Rows::ensure(luminance);
  if (!rows || rows.ndim() != 2) throw InvalidInput("luminance must be (h, w) numbers");
  constexpr py::ssize_t most = 1 << 20;
  if (rows.shape(0) > most || rows.shape(1) > most) throw InvalidInput("luminance is too large");
  std::vector<float> values(rows.data(), rows.data() + rows.size());
  return std::make_shared<Texture>(static_cast<int>(rows.shape(1)), static_cast<int>(rows.shape(0)),
                                   std::move(values), wrap_named(wrap));
}

// Of faces, or of corners: by its length.
void read_reflectance(const py::object& reflectance, const py::object& uv,
                      const py::object& textures, const py::object& face_textures,
                      PolygonMesh& mesh) {
  Reflectance& result = mesh.reflectance;
  if (!reflectance.is_none()) {
    std::vector<double> values = read_numbers(reflectance, "reflectance");
    const bool of_corners = values.size() == mesh.corner_vertices.size();
    (of_corners ? result.corners : result.faces) = std::move(values);
  }
  read_if_given(uv, "uv", result.uv, read_pairs);
  read_if_given(face_textures, "face_textures", result.face_textures, read_indices);
  for (const py::handle& texture : textures) {
    if (!py::isinstance<Texture>(texture)) {
      throw InvalidInput("textures[" + std::to_string(result.textures.size()) +
                         "] is not a Texture");
    }
    result.textures.push_back(texture.cast<std::shared_ptr<Texture>>());
  }
}

void bind_texture(py::module_& m) {
  using namespace py::literals;
  py::class_<Texture, std::shared_ptr<Texture>>(m, "Texture", "An image as luminance. Immutable.")
      .def(py::init(&make_texture), "luminance"_a, "wrap"_a = "repeat");
}

std::shared_ptr<PolygonMesh> make_mesh(
    const py::object& positions, const py::object& face_sizes, const py::object& corner_vertices,
    const py::object& edge_vertices, const py::object& edge_sharpness,
    const py::object& vertex_sharpness, const py::object& marked_edges,
    const py::object& face_materials, const py::object& hole_faces, const std::string& boundary,
    double crease_angle_deg, const py::object& scheme, const py::object& level,
    const py::object& edge_length, const std::string& name, const py::object& corner_normals,
    bool cage, const py::object& loose_edges, const py::object& reflectance, const py::object& uv,
    const py::object& textures, const py::object& face_textures) {
  auto mesh = std::make_shared<PolygonMesh>();
  mesh->positions = read_points(positions, "positions");
  mesh->face_sizes = read_indices(face_sizes, "face_sizes");
  mesh->corner_vertices = read_indices(corner_vertices, "corner_vertices");
  read_if_given(edge_vertices, "edge_vertices", mesh->edge_vertices, read_edges);
  read_if_given(edge_sharpness, "edge_sharpness", mesh->edge_sharpness, read_numbers);
  read_if_given(vertex_sharpness, "vertex_sharpness", mesh->vertex_sharpness, read_numbers);
  read_if_given(marked_edges, "marked_edges", mesh->marked_edges, read_edges);
  read_if_given(face_materials, "face_materials", mesh->face_materials, read_indices);
  read_if_given(hole_faces, "hole_faces", mesh->hole_faces, read_indices);
  read_if_given(corner_normals, "corner_normals", mesh->corner_normals, read_points);
  read_if_given(loose_edges, "loose_edges", mesh->loose_edges, read_edges);
  mesh->cage = cage;
  mesh->boundary = boundary_named(boundary);
  mesh->crease_angle_deg = crease_angle_deg;
  read_if_given(scheme, "scheme", mesh->scheme, read_scheme);
  read_if_given(level, "level", mesh->level, read_integer);
  read_if_given(edge_length, "edge_length", mesh->edge_length, read_number);
  mesh->name = name;
  read_reflectance(reflectance, uv, textures, face_textures, *mesh);
  validate(*mesh);
  return mesh;
}

std::shared_ptr<PolygonMesh> make_instance(const std::shared_ptr<PolygonMesh>& mesh,
                                           const py::object& placement, const py::object& name,
                                           const py::object& edge_length) {
  auto made = std::make_shared<PolygonMesh>(
      instance(mesh, read_matrix(placement, "placement"),
               name.is_none() ? mesh->name : py::cast<std::string>(name)));
  read_if_given(edge_length, "edge_length", made->edge_length, read_number);
  validate(*made);
  return made;
}

std::shared_ptr<PolygonMesh> make_deformed(const PolygonMesh& mesh, const py::object& positions,
                                           const py::object& corner_normals) {
  auto made = std::make_shared<PolygonMesh>(mesh);
  made->original.reset();
  made->placement = {};
  made->positions = read_points(positions, "positions");
  if (made->positions.size() != mesh.positions.size()) {
    throw InvalidInput("positions has " + std::to_string(made->positions.size()) +
                       " rows, but the mesh has " + std::to_string(mesh.positions.size()) +
                       " vertices");
  }
  read_if_given(corner_normals, "corner_normals", made->corner_normals, read_points);
  validate(*made);
  return made;
}

void bind_polygon_mesh(py::module_& m) {
  using namespace py::literals;
  const py::none none;
  py::class_<PolygonMesh, std::shared_ptr<PolygonMesh>>(
      m, "PolygonMesh", "Any polygon mesh in world space, whatever its defects. Immutable.")
      .def(py::init(&make_mesh), "positions"_a, "face_sizes"_a, "corner_vertices"_a,
           "edge_vertices"_a = none, "edge_sharpness"_a = none, "vertex_sharpness"_a = none,
           "marked_edges"_a = none, "face_materials"_a = none, "hole_faces"_a = none,
           "boundary"_a = "corners", "crease_angle_deg"_a = 180.0, "scheme"_a = none,
           "level"_a = none, "edge_length"_a = none, "name"_a = "", "corner_normals"_a = none,
           "cage"_a = true, "loose_edges"_a = none, "reflectance"_a = none, "uv"_a = none,
           "textures"_a = py::tuple(), "face_textures"_a = none)
      .def("instance", &make_instance, "placement"_a, "name"_a = none, "edge_length"_a = none,
           "The same mesh at another place, moved by a (4, 4) affine matrix. Where that is a "
           "similarity (no mirror, one scale), what is prepared of the mesh is made once and "
           "shared; else the result is a mesh of its own. edge_length: its own, world units.")
      .def("deformed", &make_deformed, "positions"_a, "corner_normals"_a = none,
           "The same faces with their vertices elsewhere.")
      .def_readonly("name", &PolygonMesh::name)
      .def_property_readonly("vertex_count",
                             [](const PolygonMesh& mesh) { return mesh.positions.size(); })
      .def_property_readonly("face_count",
                             [](const PolygonMesh& mesh) { return mesh.face_sizes.size(); });
}

py::array matrix_array(const Mat4& matrix) {
  std::vector<std::array<double, 4>> rows(4);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = matrix(i, j);
    }
  }
  return array_of(std::move(rows));
}

void bind_camera(py::module_& m) {
  using namespace py::literals;
  py::class_<Camera>(m, "Camera", "Perspective or orthographic, in OpenGL's convention. Immutable.")
      .def(py::init([](const py::object& projection, const py::object& view,
                       const py::object& width_px, const py::object& height_px) {
             return Camera(read_matrix(projection, "camera.projection"),
                           read_matrix(view, "camera.view"),
                           read_integer(width_px, "camera.width_px"),
                           read_integer(height_px, "camera.height_px"));
           }),
           "projection"_a, "view"_a, "width_px"_a, "height_px"_a)
      .def_property_readonly("projection",
                             [](const Camera& c) { return matrix_array(c.projection()); })
      .def_property_readonly("view", [](const Camera& c) { return matrix_array(c.view()); })
      .def_property_readonly("width_px",
                             [](const Camera& c) { return static_cast<int>(c.width_px()); })
      .def_property_readonly("height_px",
                             [](const Camera& c) { return static_cast<int>(c.height_px()); });
}

constexpr std::array<const char*, 7> light_names{"head", "sun",  "point",  "spot",
                                                 "area", "side", "ambient"};

LightKind light_kind_named(const std::string& name) {
  for (std::size_t i = 0; i < light_names.size(); ++i) {
    if (name == light_names[i]) return static_cast<LightKind>(i);
  }
  throw InvalidInput("light.kind is '" + name +
                     "', expected 'head', 'side', 'sun', 'point', 'spot', 'area' or 'ambient'");
}

const char* light_name(LightKind kind) { return light_names[static_cast<std::size_t>(kind)]; }

void require(const py::object& argument, const char* name, LightKind kind) {
  if (argument.is_none()) {
    throw InvalidInput(std::string("light.") + name + " must be given for a light of kind '" +
                       light_name(kind) + "'");
  }
}

// What a light of any kind may have besides its place, strength and direction.
struct LightDetails {
  py::object blend, falloff_distance, edges;
  bool ellipse, casts_shadows, contours, cosine;
  double spread_rad, radius;
};

void read_details(Light& light, const LightDetails& details) {
  read_if_given(details.blend, "light.blend", light.blend, read_number);
  read_if_given(details.falloff_distance, "light.falloff_distance", light.falloff_distance,
                read_number);
  light.ellipse = details.ellipse;
  light.casts_shadows = details.casts_shadows;
  light.contours = details.contours;
  light.cosine = details.cosine;
  light.spread_rad = details.spread_rad;
  light.radius = details.radius;
  if (details.edges.is_none()) return;
  const Points edges = read_points(details.edges, "light.edges");
  if (edges.size() != 2) throw InvalidInput("light.edges must be (2, 3), the sides of an area");
  light.edge_u = edges[0];
  light.edge_v = edges[1];
}

Light make_light(const std::string& kind_name, const py::object& vector, double strength,
                 const py::object& direction, const py::object& angle_rad,
                 const LightDetails& details) {
  Light light;
  light.kind = light_kind_named(kind_name);
  light.strength = strength;
  if (light.kind == LightKind::side) {
    light.vector = Vec3(-1, 1, 1);
  } else if (light.kind != LightKind::head && light.kind != LightKind::ambient) {
    require(vector, "vector", light.kind);
  }
  if (light.kind == LightKind::spot || light.kind == LightKind::area) {
    require(direction, "direction", light.kind);
  }
  if (light.kind == LightKind::spot) require(angle_rad, "angle_rad", light.kind);
  read_if_given(vector, "light.vector", light.vector, read_vector);
  read_if_given(direction, "light.direction", light.direction, read_vector);
  read_if_given(angle_rad, "light.angle_rad", light.angle_rad, read_number);
  read_details(light, details);
  return light;
}

void bind_light(py::module_& m) {
  using namespace py::literals;
  const py::none none;
  const auto vector_array = [](const Vec3& v) {
    return array_of(std::vector<double>{v[0], v[1], v[2]});
  };
  py::class_<Light>(m, "Light", "One light. Immutable.")
      .def(py::init([](const std::string& kind, const py::object& vector, double strength,
                       const py::object& direction, const py::object& angle_rad,
                       const py::object& blend, const py::object& falloff_distance,
                       const py::object& edges, bool ellipse, bool casts_shadows, bool contours,
                       bool cosine, double spread_rad, double radius) {
             return make_light(kind, vector, strength, direction, angle_rad,
                               {blend, falloff_distance, edges, ellipse, casts_shadows, contours,
                                cosine, spread_rad, radius});
           }),
           "kind"_a, "vector"_a = none, "strength"_a = 1.0, "direction"_a = none,
           "angle_rad"_a = none, "blend"_a = 0.0, "falloff_distance"_a = 0.0, "edges"_a = none,
           "ellipse"_a = false, "casts_shadows"_a = true, "contours"_a = true, "cosine"_a = true,
           "spread_rad"_a = Light{}.spread_rad, "radius"_a = 0.0)
      .def_property_readonly("kind", [](const Light& light) { return light_name(light.kind); })
      .def_property_readonly("vector",
                             [=](const Light& light) { return vector_array(light.vector); })
      .def_property_readonly("direction",
                             [=](const Light& light) { return vector_array(light.direction); })
      .def_readonly("strength", &Light::strength)
      .def_readonly("angle_rad", &Light::angle_rad)
      .def_readonly("blend", &Light::blend)
      .def_readonly("falloff_distance", &Light::falloff_distance)
      .def_property_readonly("edges",
                             [](const Light& light) {
                               return array_of(Points{light.edge_u, light.edge_v});
                             })
      .def_readonly("ellipse", &Light::ellipse)
      .def_readonly("casts_shadows", &Light::casts_shadows)
      .def_readonly("contours", &Light::contours)
      .def_readonly("cosine", &Light::cosine)
      .def_readonly("spread_rad", &Light::spread_rad)
      .def_readonly("radius", &Light::radius);
}

}  // namespace

void bind_mesh(py::module_& m) {
  bind_enumerations(m);
  bind_texture(m);
  bind_polygon_mesh(m);
  bind_camera(m);
  bind_light(m);
}

}  // namespace illustrate::bindings
