// SPDX-License-Identifier: LGPL-2.1-or-later
#include "sparse_cholesky.hpp"

#include <cholmod.h>
#include <omp.h>

#include <mutex>
#include <new>
#include <vector>

extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int threads);
}

namespace funicular {

namespace {

// From here on nested dissection saves more of factorising than its ordering takes; at 40,000 nodes minimum
// degree still takes a quarter less in all.
constexpr Index least_nodes_to_dissect = 50'000;

/// While one of these lives, OpenBLAS and CHOLMOD keep to the caller's thread. How OpenBLAS shares work among
/// threads decides how sums are rounded, and CHOLMOD's loops are so short that waking others takes a third of
/// the time. OpenBLAS's number of threads is the whole process's, so that the last one to leave restores it.
class OneThread {
public:
    OneThread() : levels_before_(omp_get_max_active_levels()) {
        omp_set_max_active_levels(0);
        const std::scoped_lock lock(guard);
        if (count++ == 0) {
            before = openblas_get_num_threads();
            openblas_set_num_threads(1);
        }
    }
    OneThread(const OneThread &) = delete;
    OneThread &operator=(const OneThread &) = delete;
    ~OneThread() {
        omp_set_max_active_levels(levels_before_);
        const std::scoped_lock lock(guard);
        if (--count == 0)
            openblas_set_num_threads(before);
    }

private:
    int levels_before_;
    static inline std::mutex guard;
    static inline int count = 0;
    static inline int before = 1;
};

/// METIS draws on the process's random numbers, from a seed that it sets itself.
std::mutex dissecting;

} // namespace

struct SparseCholesky::Backend {
    cholmod_common common{};
    cholmod_factor *factor = nullptr;
    cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;

    Backend() {
        cholmod_start(&common);
        common.print = 0;
        common.supernodal = CHOLMOD_SUPERNODAL;
        common.final_ll = 1;
        common.quick_return_if_not_posdef = 1;
        common.try_catch = 1; // errors are for us to report
        common.nmethods = 1;
    }
    Backend(const Backend &) = delete;
    Backend &operator=(const Backend &) = delete;
    ~Backend() {
        cholmod_free_dense(&solution, &common);
        cholmod_free_dense(&work_y, &common);
        cholmod_free_dense(&work_e, &common);
        cholmod_free_factor(&factor, &common);
        cholmod_finish(&common);
    }

    void check() const {
        if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE)
            throw std::bad_alloc();
    }
    void analyse(cholmod_sparse &matrix, std::span<const Index> first_unknown);
    std::vector<int> order_of_nodes(const cholmod_sparse &matrix, std::span<const Index> first_unknown);
};

namespace {

/// CHOLMOD's view of a matrix that Eigen holds.
cholmod_sparse view_of(const SparseCholesky::Matrix &lower) {
    cholmod_sparse view{};
    view.nrow = view.ncol = static_cast<std::size_t>(lower.rows());
    view.nzmax = static_cast<std::size_t>(lower.nonZeros());
    // CHOLMOD writes none of these.
    view.p = const_cast<int *>(lower.outerIndexPtr());
    view.i = const_cast<int *>(lower.innerIndexPtr());
    view.x = const_cast<double *>(lower.valuePtr());
    view.stype = -1;
    view.itype = CHOLMOD_INT;
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    view.sorted = view.packed = 1;
    return view;
}

} // namespace

/// Nodes in the order in which their unknowns are best eliminated. Ordering nodes takes a ninth of the work
/// of ordering unknowns, as those of one node have the same neighbours.
std::vector<int> SparseCholesky::Backend::order_of_nodes(const cholmod_sparse &matrix,
                                                         std::span<const Index> first_unknown) {
    const auto node_count = first_unknown.size() - 1;
    std::vector<int> movable, node_of(matrix.nrow);
    for (std::size_t node = 0; node < node_count; ++node)
        if (first_unknown[node + 1] > first_unknown[node]) {
            for (Index unknown = first_unknown[node]; unknown < first_unknown[node + 1]; ++unknown)
                node_of[unknown] = static_cast<int>(movable.size());
            movable.push_back(static_cast<int>(node));
        }
    const auto *columns = static_cast<const int *>(matrix.p);
    const auto *rows = static_cast<const int *>(matrix.i);
    std::vector<int> starts{0}, neighbours;
    for (const int node : movable) {
        const Index unknown = first_unknown[node];
        for (int at = columns[unknown]; at < columns[unknown + 1]; ++at)
            if (neighbours.size() == static_cast<std::size_t>(starts.back()) ||
                neighbours.back() != node_of[rows[at]])
                neighbours.push_back(node_of[rows[at]]);
        starts.push_back(static_cast<int>(neighbours.size()));
    }
    cholmod_sparse graph = matrix;
    graph.nrow = graph.ncol = movable.size();
    graph.nzmax = neighbours.size();
    graph.p = starts.data();
    graph.i = neighbours.data();
    graph.x = nullptr;
    graph.xtype = CHOLMOD_PATTERN;

    std::vector<int> order(movable.size());
    if (static_cast<Index>(movable.size()) < least_nodes_to_dissect) {
        cholmod_amd(&graph, nullptr, 0, order.data(), &common);
    } else {
        const std::scoped_lock lock(dissecting);
        cholmod_metis(&graph, nullptr, 0, 0, order.data(), &common);
    }
    check();
    for (int &node : order)
        node = movable[node];
    return order;
}

void SparseCholesky::Backend::analyse(cholmod_sparse &matrix, std::span<const Index> first_unknown) {
    std::vector<int> order;
    order.reserve(matrix.nrow);
    for (const int node : order_of_nodes(matrix, first_unknown))
        for (Index unknown = first_unknown[node]; unknown < first_unknown[node + 1]; ++unknown)
            order.push_back(static_cast<int>(unknown));
    common.method[0].ordering = CHOLMOD_GIVEN;
    factor = cholmod_analyze_p(&matrix, order.data(), nullptr, 0, &common);
    check();
}

SparseCholesky::SparseCholesky() : backend_(std::make_unique<Backend>()) {}
SparseCholesky::~SparseCholesky() = default;

bool SparseCholesky::factorise(const Matrix &lower, std::span<const Index> first_unknown) {
    if (lower.rows() == 0)
        return true;
    if (!lower.coeffs().allFinite()) // CHOLMOD would not notice
        return false;
    Backend &backend = *backend_;
    cholmod_sparse matrix = view_of(lower);
    if (backend.factor == nullptr)
        backend.analyse(matrix, first_unknown);
    if (backend.factor == nullptr)
        return false;
    const OneThread one_thread;
    cholmod_factorize(&matrix, backend.factor, &backend.common);
    backend.check();
    return backend.common.status == CHOLMOD_OK && backend.factor->minor == backend.factor->n;
}

void SparseCholesky::solve(const Eigen::VectorXd &right, Eigen::VectorXd &solution) {
    solution.resize(right.size());
    if (right.size() == 0)
        return;
    Backend &backend = *backend_;
    cholmod_dense view{};
    view.nrow = view.nzmax = view.d = static_cast<std::size_t>(right.size());
    view.ncol = 1;
    view.x = const_cast<double *>(right.data()); // not written
    view.xtype = CHOLMOD_REAL;
    view.dtype = CHOLMOD_DOUBLE;
    const OneThread one_thread;
    cholmod_solve2(CHOLMOD_A, backend.factor, &view, nullptr, &backend.solution, nullptr, &backend.work_y,
                   &backend.work_e, &backend.common);
    backend.check();
    solution =
        Eigen::Map<const Eigen::VectorXd>(static_cast<const double *>(backend.solution->x), right.size());
}

} // namespace funicular
