/* Bullet (Debian libbullet-dev, single precision), two of its soft bodies on the exported
 * masses and springs; vertices outside the sheet are not used, for neither has bending.
 *
 *   drive FOLDER FRAMES step=0.005 body=pbd iterations=10
 *       btSoftBody: links of kLST = 1, which has no unit, so E maps to nothing
 *   drive ... body=springs [project=yes]
 *       btDeformableMassSpringForce, implicit: stiffness in N/m. It has one for links and
 * one for those that are marked as bending, which the diagonals are here; the first is the
 * mean along u and v. Springs of the rim, half as stiff in the export, are as stiff as the
 * others
 *
 * Of a mesh that is no grid, body=pbd has the edges as links. Capsules are shapes of Bullet's; the
 * sheet does not meet itself.
 * Mass damping c: velocities lose c step of themselves in a step, kDP; the springs have none.
 * How it is run: scene.py.
 */
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

/* What scene.py wrote: lists of numbers by name, and rows of them. */
struct Scene {
    std::map<std::string, std::vector<double>> list;
    std::set<int> held;
    const double *row(const char *name, size_t width, size_t n) const
    {
        return &list.at(name).at(width * n);
    }
    size_t rows(const char *name, size_t width) const
    {
        return list.at(name).size() / width;
    }
    double number(const char *name) const
    {
        return list.at(name).at(0);
    }
    btVector3 vector(const char *name, size_t n) const
    {
        const double *x = row(name, 3, n);
        return btVector3(x[0], x[1], x[2]);
    }
    size_t count() const
    {
        return (size_t)number("count");
    }
};

static Scene read(const std::string &folder)
{
    std::ifstream in(folder + "/plain.txt");
    Scene s;
    for (std::string line, name; std::getline(in, line);) {
        std::stringstream words(line);
        words >> name;
        auto &numbers = s.list[name];
        for (double value; words >> value;)
            numbers.push_back(value);
    }
    for (const double v : s.list["held"])
        s.held.insert((int)v);
    return s;
}

enum { SPRING_A, SPRING_B, STIFFNESS, LENGTH, DIAGONAL, SPRING };

static btSoftBody *make_sheet(btSoftBodyWorldInfo &info, const Scene &scene)
{
    std::vector<btVector3> x;
    std::vector<btScalar> mass;
    for (size_t v = 0; v < scene.count(); v++) {
        x.push_back(scene.vector("x", v));
        mass.push_back(scene.held.count((int)v) ? 0 : *scene.row("mass", 1, v));
    }
    auto *sheet = new btSoftBody(&info, (int)x.size(), x.data(), mass.data());
    sheet->m_materials[0]->m_kLST = 1;
    for (size_t n = 0; n < scene.rows("springs", SPRING); n++) {
        const double *r = scene.row("springs", SPRING, n);
        sheet->appendLink((int)r[SPRING_A], (int)r[SPRING_B], sheet->m_materials[0]);
        sheet->m_links[sheet->m_links.size() - 1].m_bbending = r[DIAGONAL] != 0;
    }
    sheet->m_cfg.kDG = sheet->m_cfg.kLF = sheet->m_cfg.kVCF = 0;
    sheet->m_cfg.collisions = 0;
    sheet->m_cfg.kDF = 0;
    sheet->getCollisionShape()->setMargin(scene.number("h") / 2);
    sheet->setActivationState(DISABLE_DEACTIVATION);
    return sheet;
}

static void still_air(btSoftBodyWorldInfo &info, const btVector3 &g)
{
    info.air_density = 0;
    info.m_gravity = g;
}

static void add_body(btDynamicsWorld *world, btCollisionShape *shape,
                     const btTransform &place, double friction)
{
    auto *body = new btRigidBody(0, nullptr, shape);
    body->setWorldTransform(place);
    body->setFriction(friction);
    world->addRigidBody(body);
}

/* Balls and capsules that stand still. The contact's friction is the product of both, so
 * the sheet's is 1. */
static void add_obstacles(btDynamicsWorld *world, const Scene &scene, btSoftBody *sheet,
                          int kind)
{
    for (size_t n = 0; n < scene.rows("ball", 5); n++) {
        const double *r = scene.row("ball", 5, n);
        add_body(world, new btSphereShape(r[3]),
                 btTransform(btQuaternion::getIdentity(), btVector3(r[0], r[1], r[2])),
                 r[4]);
    }
    double pitch = INFINITY;
    for (size_t n = 0; n < scene.rows("capsules", 8); n++) { /* Bullet's lie along z here */
        const double *r = scene.row("capsules", 8, n);
        const btVector3 from(r[0], r[1], r[2]), to(r[3], r[4], r[5]), z(0, 0, 1);
        add_body(world, new btCapsuleShapeZ(r[6], (to - from).length()),
                 btTransform(shortestArcQuat(z, (to - from).normalized()), (from + to) / 2),
                 r[7]);
        pitch = std::min(pitch, r[6] / 4);
    }
    if (pitch < INFINITY) { /* distances are kept on a grid, of 0.25 m as it comes */
        sheet->getWorldInfo()->m_sparsesdf.setDefaultVoxelsz(pitch);
        sheet->getWorldInfo()->m_sparsesdf.Reset();
    }
    if (scene.rows("ball", 5) + scene.rows("capsules", 8) == 0)
        return;
    sheet->m_cfg.kDF = 1;
    sheet->m_cfg.collisions = kind;
}

struct World {
    btDynamicsWorld *world;
    btSoftBody *sheet;
};

static World make_world(const Scene &scene, std::map<std::string, std::string> &set)
{
    const btVector3 gravity = scene.vector("gravity", 0);
    const double lost = scene.number("damping") * std::stod(set["step"]); // of v in a step
    auto *config = new btSoftBodyRigidBodyCollisionConfiguration();
    auto *dispatcher = new btCollisionDispatcher(config);
    auto *phase = new btDbvtBroadphase();
    if (set["body"] == "pbd") {
        auto *world = new btSoftRigidDynamicsWorld(
            dispatcher, phase, new btSequentialImpulseConstraintSolver(), config);
        still_air(world->getWorldInfo(), gravity);
        world->setGravity(gravity);
        auto *sheet = make_sheet(world->getWorldInfo(), scene);
        sheet->m_cfg.piterations = std::stoi(set["iterations"]);
        sheet->m_cfg.kDP = lost;
        world->addSoftBody(sheet);
        add_obstacles(world, scene, sheet, btSoftBody::fCollision::SDF_RS);
        return {world, sheet};
    }
    if (lost > 0)
        throw std::runtime_error("Bullet's implicit springs have no drag: nothing reads "
                                 "m_cfg.drag or setDampingCoefficient()");
    if (scene.number("stretch") == 0)
        throw std::runtime_error("Bullet's implicit springs have one stiffness, and those of a "
                                 "mesh that is no grid differ");
    auto *bodies = new btDeformableBodySolver();
    auto *solver = new btDeformableMultiBodyConstraintSolver();
    solver->setDeformableSolver(bodies);
    auto *world =
        new btDeformableMultiBodyDynamicsWorld(dispatcher, phase, solver, config, bodies);
    still_air(world->getWorldInfo(), gravity);
    world->setGravity(gravity);
    auto *sheet = make_sheet(world->getWorldInfo(), scene);
    world->addSoftBody(sheet);
    add_obstacles(world, scene, sheet, btSoftBody::fCollision::SDF_RD);
    world->addForce(sheet,
                    new btDeformableMassSpringForce(scene.number("stretch"), 0, true,
                                                    scene.number("shear")));
    world->addForce(sheet, new btDeformableGravityForce(gravity));
    world->setImplicit(true);
    world->setLineSearch(false);
    world->setUseProjection(set["project"] == "yes");
    return {world, sheet};
}

/* Whether a vertex is not finite, or further off than it can have come. */
static bool is_lost(const Scene &scene, double t, const btSoftBody *sheet)
{
    const double *reach = scene.row("reach", 2, 0), far = reach[0] + reach[1] * t * t;
    for (size_t v = 0; v < scene.count(); v++)
        if (!((sheet->m_nodes[(int)v].m_x - scene.vector("x", v)).length() <= far))
            return true;
    return false;
}

static void drive(const Scene &scene, World w, double step, double until, FILE *out)
{
    double seconds = 0, died = 0;
    long done = 0;
    for (const double t : scene.list.at("times")) {
        if (t > until + 1e-9)
            continue;
        for (; done < std::lround(t / step) && died == 0; done++) {
            const clock_t start = clock(); // of the processor
            w.world->stepSimulation(step, 1, step);
            seconds += (clock() - start) / (double)CLOCKS_PER_SEC;
            if (is_lost(scene, (done + 1) * step, w.sheet))
                died = (done + 1) * step;
        }
        if (died > 0)
            break;
        fprintf(out, "%.12g", t);
        for (size_t v = 0; v < scene.count(); v++) {
            const btVector3 x = w.sheet->m_nodes[(int)v].m_x;
            fprintf(out, " %.9g %.9g %.9g", x.x(), x.y(), x.z());
        }
        fprintf(out, "\n");
    }
    printf("{\"version\": \"%d.%d\", \"seconds\": %.6g", btGetVersion() / 100,
           btGetVersion() % 100, seconds);
    printf(died > 0 ? ", \"died\": %.6g}\n" : "}\n", died);
}

int main(int count, char **words)
{
    try {
        std::map<std::string, std::string> set;
        for (int i = 3; i < count; i++) {
            const std::string word = words[i];
            set[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
        }
        const Scene scene = read(count > 2 ? words[1] : "");
        FILE *out = fopen(words[2], "w");
        if (!out)
            throw std::runtime_error(std::string(words[2]) + " cannot be written");
        drive(scene, make_world(scene, set), std::stod(set["step"]),
              set.count("until") ? std::stod(set["until"]) : INFINITY, out);
        return fclose(out) ? 1 : 0;
    } catch (const std::exception &e) {
        fprintf(stderr, "%s\n", e.what());
        return 2;
    }
}
