#include <gtest/gtest.h>

#include "core/errors.h"
#include "field/families/families.h"
#include "field/joined_field.h"
#include "surface/instances.h"
#include "tests/cpp/field/field_checks.h"

namespace illustrate {
namespace {

using namespace field_checks;

// The cross along `direction` at every vertex, each by a branch of chance.
template <class Direction>
CrossField cross_along(const Surface& surface, const Direction& direction, unsigned seed = 1) {
  SeededNumbers numbers(seed);
  CrossField field;
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    const Vec3& n = surface.normals[v];
    const Vec3 d = direction(surface.positions[v]);
    const Vec3 along = (d - d.dot(n) * n).normalized();
    field.directions.push_back(numbers.uniform() < 0 ? along : Vec3(n.cross(along)));
  }
  return field;
}

Vec3 kept_direction(const Surface& surface, const CrossField& field, const Families& families,
                    std::size_t v) {
  const Vec3& d = field.directions[v];
  return families[v] > 0 ? d : Vec3(surface.normals[v].cross(d));
}

Vec3 round_z(const Vec3& p) { return Vec3::UnitZ().cross(p); }

// Of the triangles whose corners do not keep directions that agree.
int seam_triangles(const Surface& surface, const CrossField& field, const Families& families) {
  int count = 0;
  for (const Triangle& t : surface.triangles) {
    bool agree = true;
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = kept_direction(surface, field, families, index_of(t[k]));
      const Vec3 b = kept_direction(surface, field, families, index_of(t[next_corner(k)]));
      agree &= std::abs(a.dot(b)) > 0.7;
    }
    count += !agree;
  }
  return count;
}

TEST(Families, RoundACylinder) {
  const Surface surface = cylinder(24, 12, Vec3(1, 2, 3).normalized());
  const Vec3 axis = Vec3(1, 2, 3).normalized();
  const CrossField field = cross_along(surface, [&](const Vec3&) { return axis; });
  const Families families = find_families(surface, surface.curvature, field);
  for (std::size_t v = 0; v < families.size(); ++v) {
    EXPECT_NEAR(kept_direction(surface, field, families, v).dot(axis), 0, 1e-9) << v;
  }
}

TEST(Families, RoundTheTubeOfATorus) {
  const Surface surface = shapes::torus_surface(1, 0.4, 90, 40);
  const CrossField field = cross_along(surface, round_z);
  const Families families = find_families(surface, surface.curvature, field);
  for (std::size_t v = 0; v < families.size(); ++v) {
    const Vec3 kept = kept_direction(surface, field, families, v);
    EXPECT_NEAR(kept.dot(round_z(surface.positions[v]).normalized()), 0, 1e-9) << v;
  }
}

// The short way round bends more, but where the two forms meet a seam costs its length: on a
// cylinder with a patch that bends the other way, a small one goes with what is around.
TEST(Families, SeamsArePaidFor) {
  for (const double size : {0.15, 1.2}) {
    Surface surface = cylinder(48, 24, Vec3::UnitZ());
    const Vec3 middle(1, 0, 1.5);
    std::size_t patch = 0, kept_along = 0;
    std::vector<std::size_t> inside;
    for (std::size_t v = 0; v < surface.positions.size(); ++v) {
      if ((surface.positions[v] - middle).norm() > size) continue;
      const Vec3 round = Vec3::UnitZ().cross(surface.normals[v]);
      shapes::set_curvature(surface, v, 0, round, -8, Vec3::UnitZ());
      inside.push_back(v);
    }
    const CrossField field = cross_along(surface, [](const Vec3&) { return Vec3::UnitZ(); });
    const Families families = find_families(surface, surface.curvature, field);
    for (const std::size_t v : inside) {
      ++patch;
      kept_along += std::abs(kept_direction(surface, field, families, v).z()) > 0.9;
    }
    ASSERT_GT(patch, 3U);
    const double share = double(kept_along) / double(patch);
    EXPECT_TRUE(size < 1 ? share == 0 : share > 0.8) << size << ": " << share;
  }
}

// Flat faces take their longer way; creases are seams that cost nothing.
TEST(Families, AlongTheFacesOfABox) {
  const Surface box = creased([] {
    PolygonMesh mesh = shapes::cube();
    for (Vec3& p : mesh.positions) p = p.cwiseProduct(Vec3(1, 2, 4));
    return mesh;
  }());
  const CrossField field = solved(box, {});
  const Families families = find_families(box, Curvature(box.positions.size()), field);
  EXPECT_EQ(seam_triangles(box, field, families), 0);
  for (std::size_t v = 0; v < families.size(); ++v) {
    const Vec3 kept = kept_direction(box, field, families, v);
    const bool has_height = std::abs(box.normals[v].z()) < 0.5;
    EXPECT_NEAR(std::abs(has_height ? kept.z() : kept.y()), 1, 1e-6) << v;
  }
}

TEST(Families, OfOneSheetAreThoseOfBoth) {
  const Surface klein = unorientable(shapes::klein_mesh(60, 24));
  const CrossField field = solved(klein, all_free());
  const Families families = find_families(klein, klein.curvature, field);
  CrossField turned = field;
  for (std::size_t v = 0; v < families.size(); v += 2) {
    turned.directions[v] = klein.normals[v].cross(field.directions[v]);
  }
  const Families again = find_families(klein, klein.curvature, turned);
  for (std::size_t v = 0; v < families.size(); ++v) {
    EXPECT_EQ(families[v] == again[v], v % 2 == 1) << "whichever direction stands for the cross";
  }
  Surface other = klein;  // the other sheet of some triangles is kept
  for (std::size_t v = 0; v < families.size(); ++v) {
    if (v % 3 != 0) continue;
    other.normals[v] = -other.normals[v];
    other.curvature[v].k1 *= -1;
    other.curvature[v].k2 *= -1;
    for (std::size_t t = 0; t < other.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        if (index_of(other.triangles[t][k]) == v) {
          other.flips[t] = static_cast<std::uint8_t>(other.flips[t] ^ 1 << k);
        }
      }
    }
  }
  EXPECT_EQ(find_families(other, other.curvature, field), families);
}

TEST(Families, OfAnObjectDoNotDependOnOthers) {
  const Surface one = blob(3), other = shapes::torus_surface(1, 0.4, 30, 20);
  const CrossField of_one = solved(one, all_free()), of_other = solved(other, all_free());
  const Families alone = find_families(one, one.curvature, of_one);
  CrossField both = of_other;
  both.directions.insert(both.directions.end(), of_one.directions.begin(), of_one.directions.end());
  const Surface joined = shapes::joined(other, one);
  const Families together = find_families(joined, joined.curvature, both);
  EXPECT_TRUE(std::equal(alone.begin(), alone.end(), together.end() - long(alone.size())));
}

TEST(Families, AreTheSameAtAnySizeAndCanBeCancelled) {
  Surface surface = blob(3);
  const CrossField field = solved(surface, all_free());
  const Families families = find_families(surface, surface.curvature, field);
  EXPECT_EQ(find_families(surface, surface.curvature, field), families);
  for (Vec3& p : surface.positions) p *= 1024;
  for (PrincipalCurvature& k : surface.curvature) k.k1 /= 1024, k.k2 /= 1024;
  EXPECT_EQ(find_families(surface, surface.curvature, field), families);
  int calls = 0;
  const Progress progress([&](double, const std::string&) { return ++calls < 3; }, "field");
  EXPECT_THROW(find_families(surface, surface.curvature, field, {}, 1, progress), Cancelled);
  EXPECT_TRUE(find_families({}, {}, {}).empty());
}

// An odd number of seams ends at each singularity: there, three corners cannot all agree.
TEST(Families, SeamsAreFewAndReachEverySingularity) {
  const Surface surface = blob(4);
  const CrossField field = solved(surface, all_free());
  const Families families = find_families(surface, surface.curvature, field);
  const int seams = seam_triangles(surface, field, families);
  EXPECT_GT(seams, 0);
  EXPECT_LT(seams, static_cast<int>(surface.triangles.size()) / 8);
}

// What moves only a little keeps its families, also those that a new search would change.
TEST(Families, OfTheLastFrameStay) {
  const Surface first = blob(4);
  const CrossField first_field = solved(first, all_free());
  Families before = find_families(first, first.curvature, first_field);
  for (std::int8_t& family : before) family = static_cast<std::int8_t>(-family);
  Surface second = first;
  const Eigen::AngleAxisd turn(2, Vec3(1, 2, 2).normalized());
  CrossField second_field = first_field;
  for (std::size_t v = 0; v < before.size(); ++v) {
    second.positions[v] = turn * first.positions[v] + Vec3(3, 0, 1);
    second.positions[v].z() *= 1.01;
    second.normals[v] = turn * first.normals[v];
    second_field.directions[v] = turn * first_field.directions[v];
    if (v % 2) second_field.directions[v] = second.normals[v].cross(second_field.directions[v]);
  }
  const LastFamilies last{&first, &first_field, &before};
  const Families after = find_families(second, second.curvature, second_field, last);
  std::size_t same = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    same += (after[v] == before[v]) == (v % 2 == 0);
  }
  EXPECT_GT(double(same), 0.9 * double(before.size()));
  const Surface other = blob(3);
  const CrossField of_other = solved(other, all_free());
  EXPECT_EQ(find_families(other, other.curvature, of_other, last),
            find_families(other, other.curvature, of_other))
      << "other vertices have no last frame";
}

TEST(KeptShare, TellsTheFamiliesApart) {
  const Surface surface = cylinder(24, 12, Vec3::UnitZ());
  const CrossField field = cross_along(surface, [](const Vec3&) { return Vec3::UnitZ(); });
  const Families families = find_families(surface, surface.curvature, field);
  const SurfacePoint on{40, 0.3, 0.3};
  const Vec3 round = Vec3::UnitZ().cross(normal_at(surface, on)).normalized();
  EXPECT_NEAR(kept_share(surface, field, families, on, round), 1, 0.02);
  EXPECT_NEAR(kept_share(surface, field, families, on, Vec3::UnitZ()), -1, 0.02);
  EXPECT_NEAR(kept_share(surface, field, families, on, (round + Vec3::UnitZ()).normalized()), 0,
              0.02);
}

TEST(Families, GoWithTheObjectsThatShareThem) {
  const Surface originals = shapes::joined(shapes::plain_surface(shapes::plane(1, 1)),
                                           shapes::plain_surface(shapes::plane(1, 2)));
  Instances instances;
  instances.originals = {1, 0, 1};
  instances.placements.resize(3);
  const Families families{1, 1, 1, 1, -1, 1, -1, 1, -1, 1};
  EXPECT_EQ(joined({&families}, {&originals}, instances.sources()),
            (Families{-1, 1, -1, 1, -1, 1, 1, 1, 1, 1, -1, 1, -1, 1, -1, 1}));
}

}  // namespace
}  // namespace illustrate
