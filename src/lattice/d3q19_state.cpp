#include <algorithm>
#include <stdexcept>

#include "bioprint/errors.hpp"
#include "lattice/d3q19.hpp"

namespace bioprint {

/// Between cycles the slots beside the fluid and the fields of forces and velocities hold nothing that is
/// still read: populations, the lagged viscosity and the turning that free-slip walls follow are all there is.
template <class Real>
template <class Visit>
void D3q19<Real>::each_state_row(const Visit& visit) const {
    for (int r = 0; r < fluid_rows_; ++r) {
        for (Real* const field : f_) {
            visit(field + offset(r));
        }
        visit(t_ + offset(r));
    }
    for (int point = 0; point < static_cast<int>(slip_points_.size()); ++point) {
        visit(slip_around(point));
    }
}

template <class Real>
std::vector<double> D3q19<Real>::state() const {
    if (odd_) {
        throw std::logic_error("a lattice can be kept only between cycles");
    }
    std::vector<double> state(body_force_.begin(), body_force_.end());
    each_state_row([&](const Real* row) { state.insert(state.end(), row, row + nx_); });
    return state;
}

template <class Real>
void D3q19<Real>::restore(std::span<const double> state) {
    std::size_t size = body_force_.size();
    each_state_row([&](const Real*) { size += static_cast<std::size_t>(nx_); });
    if (state.size() != size) {
        throw DataError("the checkpoint is of another lattice");
    }
    set_body_force({state[0], state[1], state[2]});
    auto from = state.begin() + static_cast<std::ptrdiff_t>(body_force_.size());
    each_state_row([&](Real* row) {
        std::transform(from, from + nx_, row, [](double value) { return static_cast<Real>(value); });
        from += nx_;
    });
    odd_ = false;
    set_window(0, nx_);
}

template class D3q19<float>;
template class D3q19<double>;

}  // namespace bioprint
