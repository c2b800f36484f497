#include <algorithm>
#include <stdexcept>
#include <string>

#include "bioprint/errors.hpp"
#include "lattice/d3q19.hpp"
#include "lattice/d3q19_stencil.hpp"

// The columns beside a window keep their populations, and what they would send into it they send in both halves
// of every cycle: the in-place half would leave it in the slots from which the streaming half reads, and the
// streaming half of the column itself would put it into the window's outermost column.

namespace bioprint {

using d3q19::directions;
using d3q19::opposite;

template <class Real>
void D3q19<Real>::set_window(int begin, int end) {
    if (odd_) {
        throw std::logic_error("a window can be set only between cycles");
    }
    if (begin % 16 != 0 || end % 16 != 0 || begin < 0 || end > nx_ || begin >= end ||
        (ends_ == Ends::periodic && (begin > 0 || end < nx_))) {
        throw UsageError(
            "a window of columns begins and ends at a multiple of 16 between two open ends, not " +
            std::to_string(begin) + " and " + std::to_string(end));
    }
    if (begin == begin_ && end == end_) {
        return;
    }
    begin_ = begin;
    end_ = end;
    borders_.clear();
    for (const bool low : {true, false}) {
        if (low ? begin > 0 : end < nx_) {
            borders_.push_back(border(low));
        }
    }
}

template <class Real>
typename D3q19<Real>::Border D3q19<Real>::border(bool low) const {
    Border border{.beside = low ? begin_ - 1 : end_, .inside = low ? begin_ : end_ - 1};
    const auto rows = static_cast<std::size_t>(fluid_rows_);
    const std::size_t padded = (rows + 15) / 16 * 16;
    std::vector<Real> column(directions * padded, Real(0));
    std::vector<Real> relaxation(padded, constants_.t0);
    d3q19::RowTask<Real> task{};
    for (int q = 0; q < directions; ++q) {
        task.f[q] = column.data() + q * padded;
        for (int r = 0; r < fluid_rows_; ++r) {
            task.f[q][r] = slot(q, r)[border.beside];
        }
    }
    for (int r = 0; r < fluid_rows_; ++r) {
        relaxation[r] = t_[offset(r) + border.beside];
    }
    std::size_t inward = 0;
    for (int q = 0; q < directions; ++q) {
        if (d3q19::velocity[q].x == (low ? 1 : -1)) {
            const Real* const own = task.f[opposite(q)];
            border.q[inward] = q;
            border.own[inward++].assign(own, own + rows);
        }
    }
    task.t = relaxation.data();
    task.blocks = static_cast<long>(padded / 16);
    (cross_ ? kernels_->cross : kernels_->newtonian)[static_cast<int>(d3q19::Coupling::none)](task,
                                                                                              constants_);
    for (std::size_t i = 0; i < border.q.size(); ++i) {
        const Real* const out = task.f[opposite(border.q[i])];
        border.sent[i].assign(out, out + rows);
    }
    return border;
}

template <class Real>
void D3q19<Real>::send_from_borders(const Share& share, bool filling) {
    const auto first = static_cast<int>(share.begin(fluid_rows_));
    const auto last = static_cast<int>(share.end(fluid_rows_));
    for (const Border& border : borders_) {
        for (std::size_t i = 0; i < border.q.size(); ++i) {
            const int q = border.q[i];
            const auto [cx, cy, cz] = d3q19::velocity[q];
            for (int r = first; r < last; ++r) {
                if (filling) {
                    slot(opposite(q), r)[border.beside] = border.sent[i][r];
                } else {
                    slot(q, neighbour_[r][3 * (1 + cy) + 1 + cz])[border.inside] = border.sent[i][r];
                }
            }
        }
    }
}

template <class Real>
void D3q19<Real>::restore_borders(const Share& share) {
    const auto first = static_cast<int>(share.begin(fluid_rows_));
    const auto last = static_cast<int>(share.end(fluid_rows_));
    for (const Border& border : borders_) {
        for (std::size_t i = 0; i < border.q.size(); ++i) {
            for (int r = first; r < last; ++r) {
                slot(opposite(border.q[i]), r)[border.beside] = border.own[i][r];
            }
        }
    }
}

template class D3q19<float>;
template class D3q19<double>;

}  // namespace bioprint
