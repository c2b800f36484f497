#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bioprint/predict/prediction.hpp"
#include "bioprint/simulate/simulation.hpp"

/// The fixed questions on which every rung of the ladder is timed and held against a converged reference.
namespace bioprint::trade {

/// What is asked: which scene, and which of its numbers is judged.
struct Kind {
    std::string name;      ///< "exit-flow", "channel", "exit", "channel-off-axis", "exit-off-axis", "shear"
    std::string quantity;  ///< as in the command's `simulated`
    SceneKind scene;
    double offset;  ///< in cell radii
};
const std::vector<Kind>& kinds();

struct Question {
    const Kind* kind;
    double alpha;
    double shear_modulus;  ///< [Pa]
    double velocity;       ///< [m/s]
    [[nodiscard]] Case to_case() const;
    /// "exit alpha=0.3 mu=1000 u=0.005"
    [[nodiscard]] std::string label() const;
};

/// All questions: α 0, 0.3, 0.75; μ 0.2, 1, 50 kPa; 0.5 and 5 cm/s, as far as they matter to the kind.
std::vector<Question> questions();

/// What loads the cell, over its shear modulus: says how soft a question's cell is.
///   channel G R_c/μ;  exit σ_elong/μ;  off the axis σ_f/μ at the cell's centre;  exit-flow 0
double load_of(const Question& question, const Prediction& prediction);

/// The judged number by the steady theory or the ellipsoid carried in time; none where the model has no answer.
std::optional<double> predicted(const Question& question, const Prediction& prediction, bool transient);

}  // namespace bioprint::trade
