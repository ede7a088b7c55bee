// A suspended wheelset on two rails in Simbody, in three dimensions: a Force::Custom finds the contacts of cone and rail head, takes load
// and ellipse from the approach (Hertz, exact inverse) and the creep forces from kstrip_solve_motion().
//
//   make && c++ -std=c++17 -O2 -Iinclude -I/usr/include/simbody hosts/simbody/wheelset.cpp target/lib/libkstrip.a
//      -lSimTKsimbody -lSimTKmath -lSimTKcommon -o target/wheelset && target/wheelset
//
// Prints its figures and checks them: the exit code is 0 when all hold.
#include <Simbody.h>
#include <kstrip.h>

#include <complex>
#include <cstdio>
#include <cstdlib>

using namespace SimTK;

namespace {

constexpr double half_gauge = 0.75, radius = 0.46, cone = 0.1, head = 0.3, friction = 0.2, car_load = 2 * 80e3 - 1800 * 9.81;
constexpr double damping = 5; // of the approach [s/m]

void check(kstrip_status status)
{
    if (status < 0) throw std::runtime_error(kstrip_status_string(status));
}

// Axes: x forward, y right, z down; they travel at `speed`, so that the rails run backward. kstrip has the same axes.
class WheelRail : public Force::Custom::Implementation {
public:
    WheelRail(const MobilizedBody &wheelset, const double &speed, const kstrip_options &options)
        : body(wheelset), speed(speed), options(options)
    {
    }
    bool dependsOnlyOnPositions() const override { return false; }
    Real calcPotentialEnergy(const State &) const override { return 0; }
    void calcForce(const State &s, Vector_<SpatialVec> &forces, Vector_<Vec3> &, Vector &) const override
    {
        const Vec3 centre = body.getBodyOriginLocation(s), axle = body.getBodyRotation(s).y(), ahead(1, 0, 0), down(0, 0, 1);
        const Vec3 below = (down - dot(down, axle) * axle).normalize(); // from the axle to the lowest points of the wheels
        const Vec3 v = body.getBodyOriginVelocity(s), turn = body.getBodyAngularVelocity(s);
        const kstrip_combined_material steel = {82e9, 0.28, 0};
        const kstrip_radii radii = {INFINITY, head, radius * std::sqrt(1 + cone * cone), INFINITY};
        for (int side = -1; side <= 1; side += 2) {
            // The tread below the axle is a line along `tread`; the normal n points into the rail, and out of the track.
            const Vec3 tread = (axle - side * cone * below).normalize(), n = (below + side * cone * axle).normalize();
            const Vec3 start = centre + side * half_gauge * axle + radius * below;
            // Centre of the rail head, in the plane of tread and normal
            const double tilt = std::atan(cone);
            Vec3 rail(centre[0], side * (half_gauge + head * std::sin(tilt)), head * std::cos(tilt));
            const Vec3 across = cross(tread, n);
            rail[0] += dot(start - rail, across) / across[0];
            const Vec3 p = start + dot(rail - start, tread) * tread, arm = p - centre; // foot of the perpendicular

            kstrip_contact contact;
            check(kstrip_contact_from_approach(&radii, &steel, head - dot(rail - start, n), friction, &contact, nullptr));
            const Vec3 approaching = v + cross(turn, arm);
            contact.normal_force *= std::max(0.0, 1 + damping * dot(approaching, n));

            // Contact plane: x along the rail, y in the plane; the rail moves with -speed.
            const Vec3 x = (ahead - dot(ahead, n) * n).normalize(), y = cross(n, x), slip = approaching + Vec3(speed, 0, 0);
            const kstrip_motion motion = {dot(slip, x), dot(slip, y), dot(turn, n), speed, 0};
            kstrip_result f;
            const kstrip_motion_outputs outputs = {&f, nullptr, nullptr};
            check(kstrip_solve_motion(&contact, &motion, nullptr, &options, &outputs));
            const Vec3 on_wheel = -contact.normal_force * n - f.fx * x - f.fy * y;
            body.applyBodyForce(s, SpatialVec(cross(arm, on_wheel) - f.mz * n, on_wheel), forces);
        }
    }

private:
    const MobilizedBody body;
    const double &speed;
    const kstrip_options &options;
};

// Axle boxes in a frame that runs straight on; the car's weight on them
class Suspension : public Force::Custom::Implementation {
public:
    explicit Suspension(const MobilizedBody &boxes) : boxes(boxes) {}
    bool dependsOnlyOnPositions() const override { return false; }
    Real calcPotentialEnergy(const State &) const override { return 0; }
    void calcForce(const State &s, Vector_<SpatialVec> &, Vector_<Vec3> &, Vector &mobility) const override
    {
        const Vector q = boxes.getQAsVector(s), u = boxes.getUAsVector(s); // roll, pitch, yaw, x, y, z
        const double stiffness[6] = {0, 5e5, 3e6, 2e7, 400e3, 0}, damper[6] = {0, 5e3, 0, 2e5, 0, 0};
        for (int i = 0; i < 6; i++) boxes.applyOneMobilityForce(s, i, -stiffness[i] * q[i] - damper[i] * u[i], mobility);
        boxes.applyOneMobilityForce(s, 5, car_load, mobility);
    }

private:
    const MobilizedBody boxes;
};

struct Wheelset {
    double speed = 20;
    kstrip_options options = {};
    MultibodySystem system;
    SimbodyMatterSubsystem matter{system};
    GeneralForceSubsystem forces{system};
    State rest;

    Wheelset()
    {
        Force::UniformGravity(forces, matter, Vec3(0, 0, 9.81));
        const Body::Rigid box(MassProperties(200, Vec3(0), Inertia(100, 20, 100))), axle(MassProperties(1600, Vec3(0), Inertia(1000, 120, 1000)));
        MobilizedBody::Bushing boxes(matter.Ground(), Vec3(0), box, Vec3(0));
        const Transform along_y(Rotation(-Pi / 2, XAxis), Vec3(0)); // a Pin turns about its z
        const MobilizedBody::Pin wheels(boxes, along_y, axle, along_y);
        Force::Custom(forces, new WheelRail(wheels, speed, options));
        Force::Custom(forces, new Suspension(boxes));
        system.realizeTopology();
        rest = system.getDefaultState();
    }
    // d/dt of the boxes' six coordinates and of all seven velocities; the wheels' angle counts for nothing
    Vector rates(State s) const
    {
        system.realize(s, Stage::Acceleration);
        Vector r(13);
        for (int i = 0; i < 6; i++) r[i] = s.getQDot()[i];
        for (int i = 0; i < 7; i++) r[6 + i] = s.getUDot()[i];
        return r;
    }
    // Rolling straight on: height and wheel speed so that nothing accelerates
    State rolling() const
    {
        State s = rest;
        s.updQ() = 0, s.updU() = 0;
        s.updQ()[5] = -radius + 1e-4, s.updU()[6] = -speed / radius;
        for (int iteration = 0; iteration < 30; iteration++) {
            auto moved = [&](double height, double wheels) {
                State c = s;
                c.updQ()[5] += height, c.updU()[6] += wheels;
                const Vector r = rates(c);
                return Vec2(r[11], r[12]);
            };
            const Vec2 f = moved(0, 0), a = (moved(1e-9, 0) - f) / 1e-9, b = (moved(0, 1e-6) - f) / 1e-6;
            const double determinant = a[0] * b[1] - a[1] * b[0];
            s.updQ()[5] -= (f[0] * b[1] - f[1] * b[0]) / determinant;
            s.updU()[6] -= (a[0] * f[1] - a[1] * f[0]) / determinant;
        }
        return s;
    }
    // The eigenvalue of hunting of Simbody's own equations, linearised about rolling
    std::complex<double> eigenvalue() const
    {
        const State s = rolling();
        Matrix A(13, 13);
        for (int k = 0; k < 13; k++) {
            const double h = k < 6 ? 1e-8 : 1e-6;
            auto moved = [&](double by) {
                State c = s;
                (k < 6 ? c.updQ()[k] : c.updU()[k - 6]) += by;
                return rates(c);
            };
            A(k) = (moved(h) - moved(-h)) / (2 * h);
        }
        Vector_<std::complex<double>> values;
        Eigen(A).getAllEigenValues(values);
        std::complex<double> hunting(-INFINITY, 0);
        for (int i = 0; i < values.size(); i++)
            if (values[i].imag() > 1 && values[i].imag() < 200 && values[i].real() > hunting.real()) hunting = values[i];
        return hunting;
    }
    // Largest |y| of the last quarter of a run; the rate at which it grew since the second [1/s]
    double growth(double aside, double seconds, double accuracy, double &last) const
    {
        State s = rolling();
        s.updQ()[4] = aside;
        CPodesIntegrator integrator(system, CPodes::BDF);
        integrator.setAccuracy(accuracy), integrator.setOrderLimit(3);
        TimeStepper stepper(system, integrator);
        stepper.initialize(s);
        double largest[4] = {};
        for (int k = 0; k < 800; k++) {
            stepper.stepTo(seconds * (k + 1) / 800);
            largest[k / 200] = std::max(largest[k / 200], std::abs(stepper.getState().getQ()[4]));
        }
        last = largest[3];
        return std::log(largest[3] / largest[1]) / (seconds / 2);
    }
};

int faults;
void check(bool holds, const char *what)
{
    if (!holds) std::printf("  MISSED: %s\n", what), faults++;
}

} // namespace

int main()
{
    Wheelset set;
    double critical = 0, last;
    for (const int model : {KSTRIP_MODEL_LINEAR, KSTRIP_MODEL_TOTAL}) {
        set.options.model = model;
        double low = 10, high = 150;
        while (high - low > 1e-3) {
            set.speed = (low + high) / 2;
            (set.eigenvalue().real() > 0 ? high : low) = set.speed;
        }
        critical = low;
        set.speed = critical;
        const double frequency = set.eigenvalue().imag() / (2 * Pi);
        // 2 % below and above, a fiftieth of a millimetre aside; growth is linear in the speed between
        set.speed = .98 * critical;
        const double below = set.growth(2e-5, 6, 1e-7, last);
        set.speed = 1.02 * critical;
        const double above = set.growth(2e-5, 6, 1e-7, last), by_runs = critical * (.98 - .04 * below / (above - below));
        std::printf("critical speed, %s: eigenvalue %.2f m/s at %.2f Hz, runs in Simbody %.2f m/s (growth %.4f and %.4f 1/s at 98 and 102 %%)\n",
                    model == KSTRIP_MODEL_LINEAR ? "LINEAR" : "TOTAL", critical, frequency, by_runs, below, above);
        check(below < 0 && above > 0 && std::abs(by_runs / critical - 1) < 2e-3, "runs and eigenvalue agree within 0.2 %");
    }
    for (const double share : {.9, 1.1}) {
        set.speed = share * critical;
        const double rate = set.growth(3e-3, 12, 1e-5, last);
        std::printf("at %.0f %% of it, 3 mm aside: %.4f mm after 12 s\n", share * 100, last * 1e3);
        if (share < 1) check(last < 3e-5, "dies away below");
        else check(std::abs(rate) < 1e-2 && last > 3e-3 && last < 0.1, "a limit cycle above");
    }
    return faults ? EXIT_FAILURE : EXIT_SUCCESS;
}
