// Runs the verilated control plane (control_plane.sv) over the sweeps of a frame.
//
//   control_plane STIMULI
//
// STIMULI is what src/peers/verilator/stimuli.rs writes, little-endian: the number of sweeps, then the words of each. The program prints
// "ready", and answers each line "frame" of its input with one line: the seconds that the frame took, what both units did in it, and
// how many sets waited for a bank at most.

#include "Vcontrol_plane.h"
#include "verilated.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

/// What one level is set up with.
struct Level {
    std::uint64_t first_x, first_y, step_x, step_y, end_range;
    std::int32_t one_x, one_y, region_x, region_y, last_x, last_y;
};

struct Sweep {
    std::int32_t phase, ticks, way_x, way_y;
    Level levels[2];
};

double sc_time_stamp() { return 0.0; }

namespace {

std::vector<Sweep> read(const char *path) {
    std::ifstream file(path, std::ios::binary);
    std::uint32_t count = 0;
    file.read(reinterpret_cast<char *>(&count), sizeof count);
    std::vector<Sweep> sweeps(count);
    for (Sweep &sweep : sweeps) {
        file.read(reinterpret_cast<char *>(&sweep.phase), 4 * sizeof(std::int32_t));
        for (Level &level : sweep.levels) {
            file.read(reinterpret_cast<char *>(&level.first_x), 5 * sizeof(std::uint64_t));
            file.read(reinterpret_cast<char *>(&level.one_x), 6 * sizeof(std::int32_t));
        }
    }
    if (!file || count == 0) {
        std::cerr << "control_plane: " << path << ": too short\n";
        std::exit(1);
    }
    return sweeps;
}

void tick(Vcontrol_plane &plane) {
    plane.clk = 1;
    plane.eval();
    plane.clk = 0;
    plane.eval();
}

void run(Vcontrol_plane &plane, const std::vector<Sweep> &sweeps) {
    for (const Sweep &sweep : sweeps) {
        plane.phase = sweep.phase;
        plane.way_x = sweep.way_x;
        plane.way_y = sweep.way_y;
        for (int n = 0; n < 2; n++) {
            const Level &level = sweep.levels[n];
            plane.first_x[n] = level.first_x;
            plane.first_y[n] = level.first_y;
            plane.step_x[n] = level.step_x;
            plane.step_y[n] = level.step_y;
            plane.end_range[n] = level.end_range;
            plane.one_x[n] = level.one_x;
            plane.one_y[n] = level.one_y;
            plane.region_x[n] = level.region_x;
            plane.region_y[n] = level.region_y;
            plane.last_x[n] = level.last_x;
            plane.last_y[n] = level.last_y;
        }
        plane.begin_sweep = 1;
        tick(plane);
        plane.begin_sweep = 0;
        for (int count = 0; count < sweep.ticks; count++) tick(plane);
    }
}

/// Counts since the unit began: the sums of both levels, in the order in which they are printed.
std::vector<std::uint32_t> counts(Vcontrol_plane &plane) {
    auto sum = [](const auto &both) { return static_cast<std::uint32_t>(both[0]) + static_cast<std::uint32_t>(both[1]); };
    return {sum(plane.folds), sum(plane.wanted), sum(plane.served), sum(plane.loads), sum(plane.late), sum(plane.corners), sum(plane.held)};
}

} // namespace

int main(int count, char **arguments) {
    if (count != 2) {
        std::cerr << "control_plane: expected one argument, the stimuli\n";
        return 1;
    }
    const std::vector<Sweep> sweeps = read(arguments[1]);
    VerilatedContext context;
    Vcontrol_plane plane{&context};
    // The first evaluation sees no edge of the clock.
    plane.eval();
    std::cout << "ready" << std::endl;
    for (std::string line; std::getline(std::cin, line);) {
        if (line != "frame") {
            std::cerr << "control_plane: expected 'frame', found '" << line << "'\n";
            return 1;
        }
        const std::vector<std::uint32_t> before = counts(plane);
        const auto begin = std::chrono::steady_clock::now();
        run(plane, sweeps);
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
        const std::vector<std::uint32_t> after = counts(plane);
        std::cout << took.count();
        for (std::size_t n = 0; n < after.size(); n++) std::cout << ' ' << after[n] - before[n];
        std::cout << ' ' << std::max(plane.longest[0], plane.longest[1]) << std::endl;
    }
    plane.final();
}
