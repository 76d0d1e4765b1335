/* Bullet (Debian libbullet-dev, single precision), two of its soft bodies on the exported
 * masses and springs; vertices outside the sheet are not used, for neither has bending.
 *
 *   drive FOLDER FRAMES.csv step=0.005 until=0.5 body=pbd iterations=10
 *       btSoftBody: links of kLST = 1, which has no unit, so E maps to nothing
 *   drive ... body=springs [project=yes]
 *       btDeformableMassSpringForce, implicit: stiffness in N/m. It has one for links and
 * one for those that are marked as bending, which the diagonals are here; springs of the
 * rim, half as stiff in the export, are as stiff as the others
 */
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

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

using Row = std::map<std::string, std::string>;

static std::vector<std::string> split(const std::string &line)
{
    std::vector<std::string> cells;
    std::stringstream in(line + ",");
    for (std::string cell; std::getline(in, cell, ',');)
        cells.push_back(cell);
    return cells;
}

static std::vector<Row> rows(const std::string &path)
{
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line))
        throw std::runtime_error(path + " cannot be read");
    const auto head = split(line);
    std::vector<Row> found;
    while (std::getline(in, line)) {
        const auto cells = split(line);
        for (size_t i = (found.emplace_back(), 0); i < head.size(); i++)
            found.back()[head[i]] = cells[i];
    }
    return found;
}

static btVector3 gravity(const std::string &path)
{
    std::ifstream in(path);
    double g[3];
    for (std::string line; std::getline(in, line);)
        if (sscanf(line.c_str(), "gravity: [%lf, %lf, %lf]", &g[0], &g[1], &g[2]) == 3)
            return btVector3(g[0], g[1], g[2]);
    throw std::runtime_error(path + " has no gravity");
}

struct Scene {
    std::vector<Row> rest, material, times;
    std::set<size_t> held;
    btVector3 gravity;
    double stiffest(const std::string &quantity) const
    {
        double most = 0;
        for (const auto &r : material)
            if (r.at("quantity") == quantity)
                most = std::fmax(most, std::stod(r.at("value")));
        return most;
    }
};

static Scene read(const std::string &folder)
{
    Scene s{rows(folder + "/rest.csv"),
            rows(folder + "/materials.csv"),
            rows(folder + "/times.csv"),
            {},
            gravity(folder + "/scene.yaml")};
    for (const auto &r : rows(folder + "/held.csv"))
        if (r.at("beside").empty())
            s.held.insert(std::stoul(r.at("vertex")));
    return s;
}

static btSoftBody *make_sheet(btSoftBodyWorldInfo &info, const Scene &scene)
{
    std::vector<btVector3> x;
    std::vector<btScalar> mass(scene.rest.size());
    for (const auto &r : scene.rest)
        x.emplace_back(std::stod(r.at("x")), std::stod(r.at("y")), std::stod(r.at("z")));
    for (const auto &r : scene.material)
        if (r.at("quantity") == "mass" && !scene.held.count(std::stoul(r.at("a"))))
            mass[std::stoul(r.at("a"))] = std::stod(r.at("value"));
    auto *sheet = new btSoftBody(&info, x.size(), x.data(), mass.data());
    sheet->m_materials[0]->m_kLST = 1;
    for (const auto &r : scene.material) {
        if (r.at("quantity").rfind("spring", 0) != 0)
            continue;
        sheet->appendLink(std::stoi(r.at("a")), std::stoi(r.at("b")),
                          sheet->m_materials[0]);
        sheet->m_links[sheet->m_links.size() - 1].m_bbending =
            r.at("quantity") == "spring diagonal";
    }
    sheet->m_cfg.kDP = sheet->m_cfg.kDG = sheet->m_cfg.kLF = sheet->m_cfg.kVCF = 0;
    sheet->m_cfg.collisions = 0;
    sheet->setActivationState(DISABLE_DEACTIVATION);
    return sheet;
}

static void still_air(btSoftBodyWorldInfo &info, const btVector3 &g)
{
    info.air_density = 0;
    info.m_gravity = g;
}

struct World {
    btDynamicsWorld *world;
    btSoftBody *sheet;
};

static World make_world(const Scene &scene, std::map<std::string, std::string> &set)
{
    auto *config = new btSoftBodyRigidBodyCollisionConfiguration();
    auto *dispatcher = new btCollisionDispatcher(config);
    auto *phase = new btDbvtBroadphase();
    if (set["body"] == "pbd") {
        auto *world = new btSoftRigidDynamicsWorld(
            dispatcher, phase, new btSequentialImpulseConstraintSolver(), config);
        still_air(world->getWorldInfo(), scene.gravity);
        world->setGravity(scene.gravity);
        auto *sheet = make_sheet(world->getWorldInfo(), scene);
        sheet->m_cfg.piterations = std::stoi(set["iterations"]);
        world->addSoftBody(sheet);
        return {world, sheet};
    }
    auto *bodies = new btDeformableBodySolver();
    auto *solver = new btDeformableMultiBodyConstraintSolver();
    solver->setDeformableSolver(bodies);
    auto *world =
        new btDeformableMultiBodyDynamicsWorld(dispatcher, phase, solver, config, bodies);
    still_air(world->getWorldInfo(), scene.gravity);
    world->setGravity(scene.gravity);
    auto *sheet = make_sheet(world->getWorldInfo(), scene);
    world->addSoftBody(sheet);
    world->addForce(sheet,
                    new btDeformableMassSpringForce(scene.stiffest("spring u"), 0, true,
                                                    scene.stiffest("spring diagonal")));
    world->addForce(sheet, new btDeformableGravityForce(scene.gravity));
    world->setImplicit(true);
    world->setLineSearch(false);
    world->setUseProjection(set["project"] == "yes");
    return {world, sheet};
}

static void drive(const Scene &scene, World w, double step, double until, FILE *out)
{
    double seconds = 0;
    long done = 0;
    fprintf(out, "t,u,v,x,y,z\n");
    for (const auto &r : scene.times) {
        const double t = r.at("what") == "truth" ? std::stod(r.at("time")) : until + 1;
        if (t > until + 1e-9)
            continue;
        const clock_t start = clock(); // of the processor
        for (; done < std::lround(t / step); done++)
            w.world->stepSimulation(step, 1, step);
        seconds += (clock() - start) / (double)CLOCKS_PER_SEC;
        for (size_t v = 0; v < scene.rest.size(); v++) {
            const btVector3 x = w.sheet->m_nodes[v].m_x;
            fprintf(out, "%.12g,%s,%s,%.9g,%.9g,%.9g\n", t, scene.rest[v].at("u").c_str(),
                    scene.rest[v].at("v").c_str(), x.x(), x.y(), x.z());
        }
    }
    printf("{\"version\": \"%d.%d\", \"seconds\": %.6g}\n", btGetVersion() / 100,
           btGetVersion() % 100, seconds);
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
              std::stod(set["until"]), out);
        return fclose(out) ? 1 : 0;
    } catch (const std::exception &e) {
        fprintf(stderr, "%s\n", e.what());
        return 2;
    }
}
