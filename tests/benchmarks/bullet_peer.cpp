#include "tests/benchmarks/bullet_peer.h"

#include <algorithm>
#include <chrono>
#include <vector>

#include <BulletSoftBody/btDefaultSoftBodySolver.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include "common/cycle/cycle.h"
#include "common/deformation/spring_network.h"
#include "common/tool/tool_shapes.h"

namespace trocar {
namespace {

constexpr double held_part = 0.1;  // of the organ's extent along the entry's normal, at the far end

/// Of 0 to 1. Stiffer links pull the nodes back into the cylinder, softer ones let them be carried further
/// than it goes: with this the dent is as deep as the cylinder goes, as with Trocar. What a step costs does
/// not depend on it.
constexpr btScalar link_stiffness = 0.03F;

btVector3 to_bullet(const Vec3& v) {
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

Vec3 from_bullet(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// A tool's pose as that of Bullet's cylinder, whose origin is its middle.
btTransform cylinder_transform(const Pose& tool) {
    const Mat3& r = tool.rotation;
    const auto at = [&](int row, int column) { return static_cast<btScalar>(r(row, column)); };
    const btMatrix3x3 rotation(at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1),
                               at(2, 2));
    return btTransform(rotation, to_bullet(tool.to_world({0, 0, default_prism_length / 2})));
}

btVector3 cylinder_half_extents() {
    return to_bullet({default_prism_radius, default_prism_radius, default_prism_length / 2});
}

}  // namespace

struct BulletPeer::World {
    World(const Organ& organ, const Placement& at, const Pose& tool, int position_iterations, Setup setup)
        : normal(at.normal),
          rest(organ.rest.positions),
          shape(cylinder_half_extents()),
          motion(cylinder_transform(tool)),
          cylinder(btRigidBody::btRigidBodyConstructionInfo(0, &motion, &shape)),
          world(&dispatcher, &broadphase, &solver, &configuration, &soft_solver) {
        world.setGravity({0, 0, 0});
        btSoftBodyWorldInfo& info = world.getWorldInfo();
        info.m_gravity = {0, 0, 0};
        info.m_sparsesdf.Initialize();
        if (setup != Setup::fresh) fill_field(info);
        cylinder.setCollisionFlags(cylinder.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
        cylinder.setActivationState(DISABLE_DEACTIVATION);
        world.addRigidBody(&cylinder);
        make_body(organ, info, position_iterations);
        if (setup != Setup::in_order) body->randomizeConstraints();
        world.addSoftBody(body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;
    ~World() {
        world.removeSoftBody(body.get());
        world.removeRigidBody(&cylinder);
    }

    void make_body(const Organ& organ, btSoftBodyWorldInfo& info, int position_iterations) {
        std::vector<btVector3> points;
        for (const Vec3& position : rest) points.push_back(to_bullet(position));
        body = std::make_unique<btSoftBody>(&info, static_cast<int>(points.size()), points.data(), nullptr);
        for (const auto& [a, b] : organ.adjacency.edges()) body->appendLink(a, b);
        for (const auto& [a, b, c] : organ.rest.facets) body->appendFace(a, b, c);

        double low = rest.front().dot(normal), high = low, area = 0;
        for (const Vec3& position : rest) {
            low = std::min(low, position.dot(normal));
            high = std::max(high, position.dot(normal));
        }
        for (const double facet_area : organ.rest_areas) area += facet_area;
        body->setTotalMass(static_cast<btScalar>(SpringSettings{}.density * area));
        for (std::size_t v = 0; v < rest.size(); ++v) {
            const double height = (rest[v].dot(normal) - low) / (high - low);
            if (height < held_part) body->setMass(static_cast<int>(v), 0);
        }
        body->getCollisionShape()->setMargin(static_cast<btScalar>(CycleSettings{}.clearance));
        body->m_cfg.piterations = position_iterations;
        body->m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
        // Trocar's damping leaves no velocity from one step to the next either.
        body->m_cfg.kDP = 1;
        // A kinematic body moves nodes all the way out, not a tenth of it.
        body->m_cfg.kKHR = 1;
        body->m_materials[0]->m_kLST = link_stiffness;
        body->updateLinkConstants();
    }

    /// Asks for the signed distance around the cylinder's tip, as a simulation that has run for a while has.
    void fill_field(btSoftBodyWorldInfo& info) {
        constexpr btScalar spacing = 0.5;       // mm; its cells are 0.75 mm wide
        constexpr int across = 12, along = 32;  // steps of it from the axis, and up from the tip
        const btScalar tip = -cylinder_half_extents().z();
        btVector3 normal_there;
        for (int x = -across; x <= across; ++x) {
            for (int y = -across; y <= across; ++y) {
                for (int z = -2; z <= along; ++z) {
                    const btVector3 step(static_cast<btScalar>(x), static_cast<btScalar>(y),
                                         static_cast<btScalar>(z));
                    info.m_sparsesdf.Evaluate(spacing * step + btVector3(0, 0, tip), &shape, normal_there, 0);
                }
            }
        }
    }

    Vec3 normal;
    std::vector<Vec3> rest;
    btSoftBodyRigidBodyCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDefaultSoftBodySolver soft_solver;
    btCylinderShapeZ shape;
    btDefaultMotionState motion;
    btRigidBody cylinder;
    std::unique_ptr<btSoftBody> body;
    btSoftRigidDynamicsWorld world;
};

BulletPeer::BulletPeer(const Organ& organ, const Placement& at, const Pose& tool, int position_iterations,
                       Setup setup)
    : world_(std::make_unique<World>(organ, at, tool, position_iterations, setup)) {}
BulletPeer::~BulletPeer() = default;

double BulletPeer::step(const Pose& tool, double dt) {
    world_->motion.setWorldTransform(cylinder_transform(tool));
    const auto start = std::chrono::steady_clock::now();
    world_->world.stepSimulation(static_cast<btScalar>(dt), 0);  // 0: one step, of just this length
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    return took.count();
}

std::size_t BulletPeer::contacts() const {
    return static_cast<std::size_t>(world_->body->m_rcontacts.size());
}

double BulletPeer::dent() const {
    double deepest = 0;
    for (std::size_t v = 0; v < world_->rest.size(); ++v) {
        const Vec3 now = from_bullet(world_->body->m_nodes[static_cast<int>(v)].m_x);
        deepest = std::max(deepest, (world_->rest[v] - now).dot(world_->normal));
    }
    return deepest;
}

}  // namespace trocar
