// How the load on a cell at the nozzle exit falls as an ink thins more strongly, at one flow rate:
// the C++ library of bioprint-predict in a program of your own. CMakeLists.txt beside this file builds it.
#include <bioprint/flow/nozzle_exit.hpp>
#include <bioprint/flow/nozzle_flow.hpp>
#include <cstdio>
#include <initializer_list>

int main() {
    const double radius = 100e-6;    // m
    const double flow_rate = 2e-10;  // m³/s, 720 µL/h
    std::puts("alpha  wall stress [Pa]  elongational stress [Pa]");
    for (const double alpha : {0.0, 0.25, 0.5, 0.75}) {
        const bioprint::CrossInk ink{.eta0 = 10.0, .time_constant = 0.05, .alpha = alpha};
        const auto flow = bioprint::NozzleFlow::from_flow_rate(ink, radius, flow_rate);
        const auto exit = bioprint::nozzle_exit(flow);
        std::printf("%5.2f  %16.1f  %24.1f\n", alpha, flow.stress_max(), exit.elongational_stress);
    }
}
