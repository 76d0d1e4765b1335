// fold.cc - Bullet (Debian libbullet-dev, single precision) and this program look for contact of the
// same folded sheet with itself, by turns in one run; a CSV row a net.
//
// Bullet's deformable body collides its faces with themselves in every step. Timed are a step
// without and with that, whose difference is what looking for contact, pushing apart and keeping
// the trees of boxes cost; of this program the search alone. Centimetres: Bullet takes triangles
// of less than 1.9 cm, if lengths are in metres, for none (proximityTest).
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyHelpers.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "fold.h"

namespace {

enum { BLOCKS = 9, CALLS = 5 };  // blocks of calls, whose median counts
const double scale = 100;        // centimetres

struct Sheet {
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btDeformableBodySolver solver;
    btDeformableMultiBodyConstraintSolver constraints;
    btDeformableMultiBodyDynamicsWorld world{&dispatcher, &broadphase, &constraints, &configuration,
                                             &solver};
    btDeformableMassSpringForce springs{1, 0, true, 0};
    btSoftBody *body;

    Sheet(int side, const double *x, bool itself) {
        constraints.setDeformableSolver(&solver);
        body = btSoftBodyHelpers::CreatePatch(world.getWorldInfo(), btVector3(0, 0, 0),
                                              btVector3(0, 1, 0), btVector3(1, 0, 0),
                                              btVector3(1, 1, 0), side, side, 0, false);
        for (int n = 0; n < side * side; n++, x += 3)
            body->m_nodes[n].m_x = body->m_nodes[n].m_q = scale * btVector3(x[0], x[1], x[2]);
        body->getCollisionShape()->setMargin(scale * fold_start);
        body->setActivationState(DISABLE_DEACTIVATION);
        body->setTotalMass(1);
        body->m_cfg.kDF = 0;
        body->m_cfg.collisions = itself ? btSoftBody::fCollision::VF_DD : 0;
        body->setSelfCollision(itself);
        body->m_softSoftCollision = itself;
        body->initializeFaceTree();
        body->updateBounds();
        world.setGravity(btVector3(0, 0, 0));
        world.addSoftBody(body);
        world.addForce(body, &springs);
    }
    void step() { world.stepSimulation(1e-5, 1, 1e-5); }
    int contacts() const { return body->m_faceNodeContacts.size(); }
};

double now() {
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * t.tv_sec + 1e-6 * t.tv_nsec;
}

double median(std::vector<double> v) {
    std::sort(v.begin(), v.end());
    return v[v.size() / 2];
}

bool run(int side, double wave) {
    fold *ours = fold_make(side, wave);
    if (!ours) return false;
    Sheet without(side, fold_places(ours), false), with(side, fold_places(ours), true);
    int contacts = 0, feet = 0;
    std::vector<double> ms[4];
    const auto time = [&](int what, auto call) {
        const double begin = now();
        for (int n = 0; n < CALLS; n++) call();
        ms[what].push_back((now() - begin) / CALLS);
    };
    for (int b = 0; b < BLOCKS; b++) {
        time(0, [&] { without.step(); });
        time(1, [&] { with.step(); });
        contacts = std::max(contacts, with.contacts());
        time(2, [&] { feet = fold_search(ours, 1); });
        time(3, [&] { feet = fold_search(ours, 0); });
    }
    const double step = median(ms[0]), theirs = median(ms[1]) - step;
    const double again = median(ms[2]), kept = median(ms[3]);
    std::printf("%dx%d,%g,%d,%d,%.4g,%.4g,%.4g,%.4g,%.3g,%.3g\n", side, side, 1e3 * wave, contacts,
                feet, step, theirs, again, kept, again / theirs, kept / theirs);
    fold_free(ours);
    return feet >= 0;
}

}  // namespace

int main() {
    for (const double wave : {0., 0.002})
        for (const int side : {32, 64, 100})
            if (!run(side, wave)) return 1;
    return 0;
}
