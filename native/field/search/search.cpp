#include "field/search/search.h"

#include <algorithm>

#include "core/parallel.h"
#include "field/problem/components.h"
#include "field/search/change.h"
#include "field/search/portfolio.h"

namespace illustrate {
namespace {

// Near the last field, a search that takes longer needs to look at all scales.
constexpr int few_evaluations = 8;

// A part with more vertices is searched on all threads and reports; of others, each thread takes so
// many vertices at a time.
constexpr std::size_t large_part = 2000;
constexpr std::size_t vertices_at_a_time = 256;

// Of a connected graph.
SearchResult search_part(const FieldGraph& graph, const SearchStarts& starts,
                         const FieldOptions& options, int threads, const Progress& progress) {
  progress.report(0);
  const bool is_wide = starts.nearby.empty() || starts.nearby[0] == CrossNumber(0);
  SearchResult found{is_wide ? starts.initial : starts.nearby, {}};
  if (is_wide) {
    found.z = portfolio_start(graph, {starts.principal, starts.initial}, progress.part(0, 0.7));
  } else if (options.start == FieldStart::search) {
    found.minimise = minimise(graph, few_evaluations, threads, found.z, progress.part(0, 0.1));
    if (!found.minimise.converged) relax_at_all_scales(graph, found.z, progress.part(0.1, 0.7));
  }
  if (!found.minimise.converged) {
    const MinimiseResult last =
        minimise(graph, options.max_evaluations, threads, found.z, progress.part(0.7, 1));
    found.minimise = {last.converged, found.minimise.evaluations + last.evaluations};
  }
  progress.report(1);
  return found;
}

CrossNumbers of_part(const CrossNumbers& z, Span<const int> vertices) {
  CrossNumbers part;
  if (z.empty()) return part;
  for (const int vertex : vertices) part.push_back(z[idx(vertex)]);
  return part;
}

class Searcher {
 public:
  Searcher(const FieldGraph& graph, const SearchStarts& starts, const FieldOptions& options)
      : graph_(graph),
        starts_(starts),
        options_(options),
        parts_(connected_vertices(graph)),
        results_(parts_.size()),
        numbers_(graph.size()),
        z_(graph.size()) {}

  SearchResult search(const Progress& progress) {
    std::vector<std::size_t> sizes;
    for (std::size_t part = 0; part < parts_.size(); ++part) sizes.push_back(vertices(part).size());
    parallel_parts(sizes, {large_part, vertices_at_a_time}, options_.threads, progress,
                   [&](std::size_t part, int threads, const Progress& of_part) {
                     search(part, threads, of_part);
                   });
    SearchResult result{std::move(z_), {true, 0}};
    for (const MinimiseResult& of_part : results_) {
      result.minimise.converged &= of_part.converged;
      result.minimise.evaluations = std::max(result.minimise.evaluations, of_part.evaluations);
    }
    return result;
  }

 private:
  Span<const int> vertices(std::size_t part) const { return parts_[part]; }

  void search(std::size_t part, int threads, const Progress& progress) {
    const Span<const int> own = vertices(part);
    const FieldGraph graph = part_of(graph_, own, numbers_);
    const SearchStarts starts{of_part(starts_.initial, own), of_part(starts_.principal, own),
                              of_part(starts_.nearby, own)};
    const SearchResult found = search_part(graph, starts, options_, threads, progress);
    for (std::size_t i = 0; i < own.size(); ++i) z_[idx(own[i])] = found.z[i];
    results_[part] = found.minimise;
  }

  const FieldGraph& graph_;
  const SearchStarts& starts_;
  const FieldOptions& options_;
  const Ragged<int> parts_;
  std::vector<MinimiseResult> results_;  // (parts)
  std::vector<int> numbers_;             // (n) of each vertex within its part
  CrossNumbers z_;                       // (n)
};

}  // namespace

SearchResult search_crosses(const FieldGraph& graph, const SearchStarts& starts,
                            const FieldOptions& options, const Progress& progress) {
  return Searcher(graph, starts, options).search(progress);
}

}  // namespace illustrate
