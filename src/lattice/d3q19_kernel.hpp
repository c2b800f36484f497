#pragma once

/// What the instruction-set specific translation units of the 3-D lattice provide: the same two row
/// operations, compiled several times. These units hold no static constructors and call no library template,
/// so that nothing compiled for a newer processor can leak into code that runs everywhere.
namespace bioprint::d3q19 {

/// The populations one row of nodes works on in place: population q is read from f[q] and the outgoing
/// population of direction q is written to f[opposite(q)]. Where f points is what distinguishes the two
/// half-steps of the in-place streaming (Bailey et al. 2009, "AA pattern").
template <class Real>
struct RowTask {
    Real* f[19];
    Real* t;               ///< 3ν of every node, kept from step to step (Cross only)
    const Real* force[3];  ///< force density field, added to the uniform one (coupled kernel only)
    Real* velocity[3];     ///< where to write the velocity (coupled and observed kernels only)
    long blocks;           ///< nodes / 16
};

template <class Real>
struct FluidConstants {
    Real body_force[3];
    Real t0;           ///< 3ν at rest; the 3ν of a Newtonian fluid
    Real t_inf;        ///< 3ν at infinite rate
    Real rate_factor;  ///< 9/2 K²
    Real half_alpha;
    Real magic;  ///< Λ = (1/λ+ − 1/2)(1/λ− − 1/2)
};

/// One wall link of a row, see D3q19: destination = near + kappa (far − back) − wall.
template <class Real>
struct LinkTask {
    Real* destination;
    const Real* near;
    const Real* far;
    const Real* back;
    const Real* wall;  ///< the wall's momentum for every node, or null for wall_constant everywhere
    Real wall_constant;
    Real kappa;
    long nodes;
};

enum class Coupling { none, observed, coupled };

template <class Real>
struct Kernels {
    using Collide = void (*)(const RowTask<Real>&, const FluidConstants<Real>&);
    using Link = void (*)(const LinkTask<Real>&);
    Collide newtonian[3];  ///< by Coupling
    Collide cross[3];
    Link link;
};

enum class InstructionSet { best, baseline, avx2, avx512 };

/// The kernels of an instruction set; `best` is the widest this processor has. Null when it has not the one
/// asked for.
template <class Real>
const Kernels<Real>* kernels(InstructionSet set);

/// The name of the instruction set `best` stands for here.
const char* best_instruction_set();

}  // namespace bioprint::d3q19
