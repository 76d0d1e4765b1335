// beside.cc - TinyVBD and this program on TinyVBD's own strands, by turns in one run; a CSV row
// each. TinyVBD's main.cpp is included as it is; WORD says in what precision it was compiled.
//   beside WORD
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <functional>
#include <iomanip>
#include <list>
#include <sstream>
#include <string>
#include <vector>

#define main tinyvbd_main
#include "main.cpp"
#undef main

#include "strand.h"

namespace {

enum { BLOCKS = 9, FRAMES = 7 };  // blocks of frames, whose median counts

struct Case {
    const char *name;
    void (StrandSim::*initialize)();
    int iterations;
    bool in_sequence;
    double softer;  // than TinyVBD has it
    bool pressed;   // springs under pressure, whose blocks vb_body keeps definite, matter
};

const Case cases[] = {
    {"3 points, the last 1000 times as heavy", &StrandSim::initializeHorizontal, 100, true, 1, false},
    {"20 points, stiffness 1e3", &StrandSim::initializeTilted, 100, true, 1e5, false},
    {"20 points, stiffness 1e3", &StrandSim::initializeTilted, 1000, false, 1e5, false},
    {"20 points, stiffness 1e8", &StrandSim::initializeTilted, 100, true, 1, true},
    {"20 points, stiffness 1e8", &StrandSim::initializeTilted, 100, false, 1, true},
    {"5 points, stiffness 1e4 and 1e8", &StrandSim::initializeStiffRatio, 100, true, 1, true},
};

struct strand *ours_of(const StrandSim &sim, const Case &one) {
    const VBDStrand &s = sim.strand;
    std::vector<double> rest, mass, stiffness, length;
    std::vector<std::array<int, 2>> ends;
    for (size_t a = 0; a < s.numVerts; a++) {
        for (int i = 0; i < 3; i++) rest.push_back(s.mVertPos(i, a));
        mass.push_back(s.vertexMass(a));
    }
    for (size_t k = 0; k < s.edges.size(); k++) {
        ends.push_back({s.edges[k][0], s.edges[k][1]});
        stiffness.push_back(s.edgesStiffness[k]);
        length.push_back(s.orgLengths(k));
    }
    const strand_plan plan = {(int)s.numVerts, (int)ends.size(), rest.data(), mass.data(),
                              (const int (*)[2])ends.data(), stiffness.data(), length.data(),
                              sim.params.dt, 10, one.in_sequence};
    return strand_make(&plan);
}

void their_frame(StrandSim &sim, int iterations) {
    sim.forwardStep();
    for (int k = 0; k < iterations; k++) sim.solve();
    sim.updateVelocity();
}

template <class Work> double seconds(Work work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

double apart(const StrandSim &sim, const struct strand *ours) {
    double most = 0;
    for (size_t a = 0; a < sim.strand.numVerts; a++)
        for (int i = 0; i < 3; i++)
            most = std::max(most, std::abs((double)sim.strand.mVertPos(i, a) -
                                           strand_places(ours)[3 * a + i]));
    return most;
}

bool run(const Case &one, const char *precision) {
    StrandSim sim;
    (sim.*one.initialize)();
    for (auto &k : sim.strand.edgesStiffness) k /= one.softer;
    struct strand *ours = ours_of(sim, one);
    if (!ours) return false;
    std::vector<double> their_ms, our_ms;
    double first = 0, last = 0;
    for (int b = 0; b < BLOCKS; b++) {
        double t = 0, u = 0;
        for (int n = 0; n < FRAMES; n++) {
            t += seconds([&] { their_frame(sim, one.iterations); });
            u += seconds([&] { strand_step(ours, one.iterations); });
            last = std::max(last, apart(sim, ours));
        }
        if (b == 0) first = last;
        their_ms.push_back(1e3 * t / FRAMES), our_ms.push_back(1e3 * u / FRAMES);
    }
    std::printf("\"%s\",%s,%s,%s,%d,%d,%.4g,%.4g,%.3g,%.2g,%.2g\n", one.name, precision,
                one.in_sequence ? "in sequence" : "by colours", one.pressed ? "yes" : "no",
                one.iterations, BLOCKS * FRAMES, median(their_ms), median(our_ms),
                median(our_ms) / median(their_ms), first, last);
    strand_free(ours);
    return true;
}

}  // namespace

int main(int argc, char **argv) {
    for (const Case &one : cases)
        if (!run(one, argc > 1 ? argv[1] : "float")) return 1;
    return 0;
}
