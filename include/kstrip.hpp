/**
 * @file kstrip.hpp
 * kstrip for C++17 and later: kstrip.h with units in the types, nothing else.
 *
 * Every structure here has the layout of its C namesake, every function is one call of its C namesake:
 * see kstrip.h for axes, signs, ranges and statuses. Each function comes in two forms:
 *
 * - outputs last, returns kstrip::status, never throws;
 * - outputs returned, throws kstrip::error if the status is negative (not there without exceptions).
 *
 * `contact`, `creepage`, ... are in double precision, `contact_f32`, `creepage_f32`, ... in single.
 */
#ifndef KSTRIP_HPP
#define KSTRIP_HPP

#include "kstrip.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define KSTRIP_HPP_EXCEPTIONS 1
#include <exception>
#endif

#if defined(__has_include)
#if __has_include(<version>)
#include <version>
#endif
#endif
#if defined(__cpp_lib_span)
#include <span>
#endif

namespace kstrip {

/// Versions of the header, for the preprocessor's job without the preprocessor.
inline constexpr int version_major = KSTRIP_VERSION_MAJOR;
inline constexpr int version_minor = KSTRIP_VERSION_MINOR;
inline constexpr int version_patch = KSTRIP_VERSION_PATCH;
inline constexpr int abi_version = KSTRIP_ABI_VERSION;
inline constexpr std::uint32_t strips_capacity = KSTRIP_STRIPS_CAPACITY;
inline constexpr std::uint32_t patch_capacity = KSTRIP_PATCH_CAPACITY;

/// Version of the library that is linked.
inline const char *linked_version() noexcept { return kstrip_version_string(); }
/// Whether the library that is linked has the binary interface of this header.
inline bool linked_abi_matches() noexcept { return kstrip_abi_version() == KSTRIP_ABI_VERSION; }

// ---- Status -----------------------------------------------------------------------------------

/// Result of a call: 0 ok; > 0 warning, outputs valid; < 0 error, outputs untouched.
enum class [[nodiscard]] status : std::int32_t {
    ok = KSTRIP_OK,
    warning_spin = KSTRIP_WARNING_SPIN,
    warning_range = KSTRIP_WARNING_RANGE,
    warning_beyond_friction = KSTRIP_WARNING_BEYOND_FRICTION,
    warning_several_frictions = KSTRIP_WARNING_SEVERAL_FRICTIONS,
    warning_not_converged = KSTRIP_WARNING_NOT_CONVERGED,
    warning_friction_at_least = KSTRIP_WARNING_FRICTION_AT_LEAST,
    warning_creepage_at_least = KSTRIP_WARNING_CREEPAGE_AT_LEAST,
    error_null = KSTRIP_ERROR_NULL,
    error_not_finite = KSTRIP_ERROR_NOT_FINITE,
    error_semi_axis = KSTRIP_ERROR_SEMI_AXIS,
    error_normal_force = KSTRIP_ERROR_NORMAL_FORCE,
    error_modulus = KSTRIP_ERROR_MODULUS,
    error_poisson_ratio = KSTRIP_ERROR_POISSON_RATIO,
    error_friction = KSTRIP_ERROR_FRICTION,
    error_model = KSTRIP_ERROR_MODEL,
    error_strip_count = KSTRIP_ERROR_STRIP_COUNT,
    error_curvature = KSTRIP_ERROR_CURVATURE,
    error_rolling_speed = KSTRIP_ERROR_ROLLING_SPEED,
    error_capacity = KSTRIP_ERROR_CAPACITY,
    error_not_in_model = KSTRIP_ERROR_NOT_IN_MODEL,
    error_overflow = KSTRIP_ERROR_OVERFLOW,
    error_friction_ratio = KSTRIP_ERROR_FRICTION_RATIO,
    error_friction_decay = KSTRIP_ERROR_FRICTION_DECAY,
    error_negative_speed = KSTRIP_ERROR_NEGATIVE_SPEED,
    error_slope_factor = KSTRIP_ERROR_SLOPE_FACTOR,
    error_unexplained = KSTRIP_ERROR_UNEXPLAINED,
    error_force_beyond_friction = KSTRIP_ERROR_FORCE_BEYOND_FRICTION,
    error_measured = KSTRIP_ERROR_MEASURED,
    error_wanted = KSTRIP_ERROR_WANTED,
    error_strip_size = KSTRIP_ERROR_STRIP_SIZE,
    error_pressure = KSTRIP_ERROR_PRESSURE,
    error_strip_order = KSTRIP_ERROR_STRIP_ORDER,
    error_patch_size = KSTRIP_ERROR_PATCH_SIZE,
    error_profile = KSTRIP_ERROR_PROFILE,
    error_profile_end = KSTRIP_ERROR_PROFILE_END,
    error_rolling_radius = KSTRIP_ERROR_ROLLING_RADIUS,
};

constexpr bool is_error(status s) noexcept { return static_cast<std::int32_t>(s) < 0; }
constexpr bool is_warning(status s) noexcept { return static_cast<std::int32_t>(s) > 0; }
/// What the status means and what to change.
inline const char *to_string(status s) noexcept
{
    return kstrip_status_string(static_cast<kstrip_status>(s));
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// Thrown by the functions that return their output.
class error : public std::exception {
public:
    explicit error(kstrip::status s) noexcept : status_(s) {}
    kstrip::status status() const noexcept { return status_; }
    const char *what() const noexcept override { return to_string(status_); }

private:
    kstrip::status status_;
};
#endif

// ---- Units ------------------------------------------------------------------------------------

/// A number with a unit. Converts from a plain number only explicitly, to one only by `value`.
template <class Unit, class T>
struct quantity {
    T value{};

    constexpr quantity() noexcept = default;
    constexpr explicit quantity(T number) noexcept : value(number) {}

    constexpr quantity operator-() const noexcept { return quantity(-value); }
    friend constexpr quantity operator+(quantity p, quantity q) noexcept { return quantity(p.value + q.value); }
    friend constexpr quantity operator-(quantity p, quantity q) noexcept { return quantity(p.value - q.value); }
    friend constexpr quantity operator*(T factor, quantity q) noexcept { return quantity(factor * q.value); }
    friend constexpr quantity operator*(quantity q, T factor) noexcept { return quantity(q.value * factor); }
    friend constexpr quantity operator/(quantity q, T divisor) noexcept { return quantity(q.value / divisor); }
    friend constexpr T operator/(quantity p, quantity q) noexcept { return p.value / q.value; }
    constexpr quantity &operator+=(quantity q) noexcept { value += q.value; return *this; }
    constexpr quantity &operator-=(quantity q) noexcept { value -= q.value; return *this; }
    friend constexpr bool operator==(quantity p, quantity q) noexcept { return p.value == q.value; }
    friend constexpr bool operator!=(quantity p, quantity q) noexcept { return p.value != q.value; }
    friend constexpr bool operator<(quantity p, quantity q) noexcept { return p.value < q.value; }
    friend constexpr bool operator<=(quantity p, quantity q) noexcept { return p.value <= q.value; }
    friend constexpr bool operator>(quantity p, quantity q) noexcept { return p.value > q.value; }
    friend constexpr bool operator>=(quantity p, quantity q) noexcept { return p.value >= q.value; }
};

namespace unit {
struct metre;
struct newton;
struct pascal;
struct per_metre;
struct newton_metre;
struct radian;
struct metre_per_second;
struct radian_per_second;
struct second_per_metre;
struct square_metre;
struct per_newton;
} // namespace unit

template <class T> using basic_metres = quantity<unit::metre, T>;
template <class T> using basic_newtons = quantity<unit::newton, T>;
template <class T> using basic_pascals = quantity<unit::pascal, T>;
template <class T> using basic_per_metre = quantity<unit::per_metre, T>;
template <class T> using basic_newton_metres = quantity<unit::newton_metre, T>;
template <class T> using basic_radians = quantity<unit::radian, T>;
template <class T> using basic_metres_per_second = quantity<unit::metre_per_second, T>;
template <class T> using basic_radians_per_second = quantity<unit::radian_per_second, T>;
template <class T> using basic_seconds_per_metre = quantity<unit::second_per_metre, T>;
template <class T> using basic_square_metres = quantity<unit::square_metre, T>;
template <class T> using basic_per_newton = quantity<unit::per_newton, T>;

using metres = basic_metres<double>;
using newtons = basic_newtons<double>;
using pascals = basic_pascals<double>;
using per_metre = basic_per_metre<double>;
using newton_metres = basic_newton_metres<double>;
using radians = basic_radians<double>;
using metres_per_second = basic_metres_per_second<double>;
using radians_per_second = basic_radians_per_second<double>;
using seconds_per_metre = basic_seconds_per_metre<double>;
using square_metres = basic_square_metres<double>;
using per_newton = basic_per_newton<double>;

using metres_f32 = basic_metres<float>;
using newtons_f32 = basic_newtons<float>;
using pascals_f32 = basic_pascals<float>;
using per_metre_f32 = basic_per_metre<float>;
using newton_metres_f32 = basic_newton_metres<float>;
using radians_f32 = basic_radians<float>;
using metres_per_second_f32 = basic_metres_per_second<float>;
using radians_per_second_f32 = basic_radians_per_second<float>;
using seconds_per_metre_f32 = basic_seconds_per_metre<float>;
using square_metres_f32 = basic_square_metres<float>;
using per_newton_f32 = basic_per_newton<float>;

/// `6.0_mm`, `80_kN`, `82_GPa`, `0.4_per_m`, `20_m_per_s`: `using namespace kstrip::literals;`
inline namespace literals {
#define KSTRIP_HPP_LITERAL(suffix, type, divisor, factor)                                         \
    constexpr type operator""_##suffix(long double v) noexcept                                    \
    {                                                                                             \
        return type(static_cast<double>(v * factor / divisor));                                   \
    }                                                                                             \
    constexpr type operator""_##suffix(unsigned long long v) noexcept                             \
    {                                                                                             \
        return type(static_cast<double>(static_cast<long double>(v) * factor / divisor));         \
    }
KSTRIP_HPP_LITERAL(m, metres, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(mm, metres, 1e3L, 1.0L)
KSTRIP_HPP_LITERAL(N, newtons, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(kN, newtons, 1.0L, 1e3L)
KSTRIP_HPP_LITERAL(Pa, pascals, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(MPa, pascals, 1.0L, 1e6L)
KSTRIP_HPP_LITERAL(GPa, pascals, 1.0L, 1e9L)
KSTRIP_HPP_LITERAL(per_m, per_metre, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(m_per_s, metres_per_second, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(rad_per_s, radians_per_second, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(s_per_m, seconds_per_metre, 1.0L, 1.0L)
#undef KSTRIP_HPP_LITERAL
} // namespace literals

// ---- Views ------------------------------------------------------------------------------------

#if defined(__cpp_lib_span)
template <class T> using span = std::span<T>;
#else
/// A pointer and a size, where std::span is not there yet.
template <class T>
class span {
public:
    constexpr span() noexcept = default;
    constexpr span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}
    template <std::size_t N>
    constexpr span(T (&array)[N]) noexcept : data_(array), size_(N) {}
    /// From anything contiguous: std::vector, std::array, another span.
    template <class C,
              class = std::enable_if_t<!std::is_array_v<std::remove_reference_t<C>> &&
                                       std::is_convertible_v<decltype(std::declval<C &>().data()), T *>>>
    constexpr span(C &&contiguous) noexcept : data_(contiguous.data()), size_(contiguous.size()) {}

    constexpr T *data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr T &operator[](std::size_t i) const noexcept { return data_[i]; }
    constexpr T *begin() const noexcept { return data_; }
    constexpr T *end() const noexcept { return data_ + size_; }

private:
    T *data_ = nullptr;
    std::size_t size_ = 0;
};
#endif

// ---- Structures -------------------------------------------------------------------------------

enum class model : std::int32_t {
    strip_1967 = KSTRIP_MODEL_STRIP_1967,
    strip_1967_continuous = KSTRIP_MODEL_STRIP_1967_CONTINUOUS,
    strip = KSTRIP_MODEL_STRIP,
    total = KSTRIP_MODEL_TOTAL,
    linear = KSTRIP_MODEL_LINEAR,
};

enum class state : std::int32_t {
    outside = KSTRIP_STATE_OUTSIDE,
    stick = KSTRIP_STATE_STICK,
    slip = KSTRIP_STATE_SLIP,
    slip_negative_dissipation = KSTRIP_STATE_SLIP_NEGATIVE_DISSIPATION,
};

/// Which force components were measured.
enum class measured : std::uint32_t {
    fx = KSTRIP_MEASURED_FX,
    fy = KSTRIP_MEASURED_FY,
    both = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY,
};

/// What evaluate() computes; `a | b` asks for both.
enum class want : std::uint32_t {
    forces = KSTRIP_WANT_FORCES,
    moment = KSTRIP_WANT_MOMENT,
    adhesion = KSTRIP_WANT_ADHESION,
    jacobian = KSTRIP_WANT_JACOBIAN,
    strips = KSTRIP_WANT_STRIPS,
};
constexpr want operator|(want p, want q) noexcept
{
    return static_cast<want>(static_cast<std::uint32_t>(p) | static_cast<std::uint32_t>(q));
}

/// Model and strip count; the same defaults as kstrip_options_init().
struct options {
    kstrip::model model = kstrip::model::strip;
    std::int32_t strips = 16;
};

template <class T>
struct basic_material {
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
};

template <class T>
struct basic_combined_material {
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T mismatch;
};

template <class T>
struct basic_radii {
    basic_metres<T> lower_x, lower_y, upper_x, upper_y;
};

template <class T>
struct basic_hertz_contact {
    basic_metres<T> a, b;
    basic_pascals<T> peak_pressure;
    basic_metres<T> approach;
    T axis_ratio;
    basic_radians<T> hertz_angle;
    basic_metres<T> rho;
};

template <class T>
struct basic_velocity {
    basic_metres_per_second<T> x, y;
    basic_radians_per_second<T> angular_z;
};

template <class T>
struct basic_creepage {
    T longitudinal, lateral;
    basic_per_metre<T> spin;
};

template <class T>
struct basic_contact {
    basic_metres<T> a, b;
    basic_newtons<T> normal_force;
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T friction;
};

template <class T>
struct basic_parameters {
    T xi, eta, psi;
};

/// Forces on the lower body.
template <class T>
struct basic_result {
    basic_newtons<T> fx, fy;
    basic_newton_metres<T> mz;
    basic_newtons<T> power; ///< power over rolling speed: joules per metre rolled
    T adhesion;
    kstrip::status status_detail;
    std::int32_t reserved;
};

template <class T>
struct basic_strip {
    basic_metres<T> y, width, half_length, separatrix;
    basic_newtons<T> fx, fy;
    basic_newton_metres<T> mz;
    basic_newtons<T> power;
    kstrip::state state;
    std::int32_t reserved;
};

template <class T>
struct basic_point {
    basic_pascals<T> pressure, traction_x, traction_y;
    T slip_x, slip_y;
    basic_pascals<T> dissipation;
    kstrip::state state;
    std::int32_t reserved;
};

/// d(fx, fy, mz)/d(longitudinal, lateral, spin), row by row [N, N, N m over 1, 1, 1/m].
template <class T>
struct basic_jacobian {
    T value[9];
    constexpr T operator()(std::size_t row, std::size_t column) const noexcept
    {
        return value[3 * row + column];
    }
};

/// Derivatives of (fx, fy, mz) with respect to creepages, load and friction.
template <class T>
struct basic_derivatives {
    basic_jacobian<T> jacobian;
    T normal_force[3];
    T friction[3];
    T load_through_hertz[3];
};

/// Friction that falls with the slip, and the stiffness of the layer.
template <class T>
struct basic_friction {
    T friction;
    T ratio = T(1);
    basic_seconds_per_metre<T> decay{};
    basic_metres_per_second<T> rolling_speed{};
    T slope_factor = T(1);
};

/// A coefficient of friction from a measured force.
template <class T>
struct basic_friction_estimate {
    T friction;
    basic_per_newton<T> sensitivity;
    basic_newtons<T> residual;
    kstrip::status status_detail;
    std::int32_t reserved;
};

/// Arrays, one for each quantity, for solve_batch_arrays().
template <class T>
struct basic_batch_inputs {
    const basic_metres<T> *a, *b;
    const basic_newtons<T> *normal_force;
    const basic_pascals<T> *shear_modulus;
    const T *poisson_ratio;
    const T *friction;
    const T *longitudinal, *lateral;
    const basic_per_metre<T> *spin;
};

/// Where solve_batch_arrays() writes; null where a quantity is not wanted.
template <class T>
struct basic_batch_outputs {
    basic_newtons<T> *fx, *fy;
    basic_newton_metres<T> *mz;
    basic_newtons<T> *power;
    T *adhesion;
    kstrip::status *status_detail;
};

/// One strip of a patch of any shape.
template <class T>
struct basic_patch_strip {
    basic_metres<T> y, width, half_length, centre_x;
    basic_pascals<T> peak_pressure;
    T friction;
};

/// A patch of any shape: its strips, in ascending y; the first `count` are used.
template <class T>
struct basic_patch {
    basic_patch_strip<T> strips[patch_capacity];
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T area_scale;
    T lever_scale;
    std::uint32_t count;
    std::uint32_t reserved;
};

/// What presses two profiles together.
template <class T>
struct basic_profile_contact {
    basic_metres<T> rolling_radius;
    basic_newtons<T> normal_force;
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T friction;
};

/// How two profiles meet under a load.
template <class T>
struct basic_profile_result {
    basic_metres<T> penetration;
    basic_pascals<T> peak_pressure;
    basic_newtons<T> normal_force;
    basic_metres<T> deepest_y;
    std::uint32_t iterations;
    std::uint32_t reserved;
};

/// What a patch carries.
template <class T>
struct basic_patch_summary {
    basic_newtons<T> normal_force, friction_bound;
    basic_square_metres<T> area;
    std::uint32_t lobes;
    std::uint32_t reserved;
};

/// Forces and their derivatives.
template <class T>
struct basic_linearised {
    basic_result<T> result;
    basic_jacobian<T> jacobian;
};

using material = basic_material<double>;
using combined_material = basic_combined_material<double>;
using radii = basic_radii<double>;
using hertz_contact = basic_hertz_contact<double>;
using velocity = basic_velocity<double>;
using creepage = basic_creepage<double>;
using contact = basic_contact<double>;
using parameters = basic_parameters<double>;
using result = basic_result<double>;
using strip = basic_strip<double>;
using point = basic_point<double>;
using jacobian = basic_jacobian<double>;
using derivatives = basic_derivatives<double>;
using friction = basic_friction<double>;
using friction_estimate = basic_friction_estimate<double>;
using batch_outputs = basic_batch_outputs<double>;
using batch_inputs = basic_batch_inputs<double>;
using patch_summary = basic_patch_summary<double>;
using profile_result = basic_profile_result<double>;
using profile_contact = basic_profile_contact<double>;
using patch = basic_patch<double>;
using patch_strip = basic_patch_strip<double>;

using material_f32 = basic_material<float>;
using combined_material_f32 = basic_combined_material<float>;
using radii_f32 = basic_radii<float>;
using hertz_contact_f32 = basic_hertz_contact<float>;
using velocity_f32 = basic_velocity<float>;
using creepage_f32 = basic_creepage<float>;
using contact_f32 = basic_contact<float>;
using parameters_f32 = basic_parameters<float>;
using result_f32 = basic_result<float>;
using strip_f32 = basic_strip<float>;
using point_f32 = basic_point<float>;
using jacobian_f32 = basic_jacobian<float>;
using derivatives_f32 = basic_derivatives<float>;
using friction_f32 = basic_friction<float>;
using friction_estimate_f32 = basic_friction_estimate<float>;
using batch_outputs_f32 = basic_batch_outputs<float>;
using batch_inputs_f32 = basic_batch_inputs<float>;
using patch_summary_f32 = basic_patch_summary<float>;
using profile_result_f32 = basic_profile_result<float>;
using profile_contact_f32 = basic_profile_contact<float>;
using patch_f32 = basic_patch<float>;
using patch_strip_f32 = basic_patch_strip<float>;

// ---- The way to C -----------------------------------------------------------------------------

namespace detail {
/// The C structure of a C++ structure: `c_type<contact>` is kstrip_contact.
template <class Cpp> struct twin;
template <class Cpp> using c_type = typename twin<Cpp>::type;

#define KSTRIP_HPP_SAME(cpp, c)                                                                   \
    template <> struct twin<cpp> { using type = c; };                                             \
    static_assert(sizeof(cpp) == sizeof(c) && alignof(cpp) == alignof(c), #cpp " has the layout of " #c); \
    static_assert(std::is_standard_layout_v<cpp> && std::is_trivially_copyable_v<cpp>, #cpp " is plain data");
#define KSTRIP_HPP_BOTH(name)                                                                     \
    KSTRIP_HPP_SAME(name, kstrip_##name)                                                          \
    KSTRIP_HPP_SAME(name##_f32, kstrip_##name##_f32)
KSTRIP_HPP_SAME(options, kstrip_options)
KSTRIP_HPP_BOTH(material)
KSTRIP_HPP_BOTH(combined_material)
KSTRIP_HPP_BOTH(radii)
KSTRIP_HPP_BOTH(hertz_contact)
KSTRIP_HPP_BOTH(velocity)
KSTRIP_HPP_BOTH(creepage)
KSTRIP_HPP_BOTH(contact)
KSTRIP_HPP_BOTH(parameters)
KSTRIP_HPP_BOTH(result)
KSTRIP_HPP_BOTH(strip)
KSTRIP_HPP_BOTH(point)
KSTRIP_HPP_BOTH(derivatives)
KSTRIP_HPP_BOTH(friction)
KSTRIP_HPP_BOTH(friction_estimate)
KSTRIP_HPP_BOTH(batch_outputs)
KSTRIP_HPP_BOTH(batch_inputs)
KSTRIP_HPP_BOTH(patch_summary)
KSTRIP_HPP_BOTH(profile_result)
KSTRIP_HPP_BOTH(profile_contact)
KSTRIP_HPP_BOTH(patch)
KSTRIP_HPP_BOTH(patch_strip)
#undef KSTRIP_HPP_BOTH
#undef KSTRIP_HPP_SAME

// The library reads and writes through these pointers in code that the C++ compiler does not see; the
// layouts are the same, so no copy is made.
template <class Cpp> const c_type<Cpp> *in(const Cpp *p) noexcept { return reinterpret_cast<const c_type<Cpp> *>(p); }
template <class Cpp> c_type<Cpp> *out(Cpp *p) noexcept { return reinterpret_cast<c_type<Cpp> *>(p); }
inline const double *in(const metres *p) noexcept { return reinterpret_cast<const double *>(p); }
inline const float *in(const metres_f32 *p) noexcept { return reinterpret_cast<const float *>(p); }

constexpr status to_status(kstrip_status s) noexcept { return static_cast<status>(s); }
/// Sizes are 32 bits wide in C.
constexpr bool fits(std::size_t size) noexcept { return size <= 0xffffffffu; }

/// Call the function of the precision.
#define KSTRIP_HPP_CALL(T, name, ...)                                                             \
    [&]() noexcept -> ::kstrip::status {                                                          \
        if constexpr (std::is_same_v<T, double>)                                                  \
            return ::kstrip::detail::to_status(::name(__VA_ARGS__));                              \
        else                                                                                      \
            return ::kstrip::detail::to_status(::name##_f32(__VA_ARGS__));                        \
    }()

#if defined(KSTRIP_HPP_EXCEPTIONS)
inline void check(status s)
{
    if (is_error(s))
        throw error(s);
}
#endif

/// The argument does not take part in finding T.
template <class T> struct same { using type = T; };
template <class T> using only = typename same<T>::type;
} // namespace detail

// ---- Functions that return a status -----------------------------------------------------------

/// kstrip_options_init()
inline status init(options &to) noexcept { return detail::to_status(kstrip_options_init(detail::out(&to))); }

/// kstrip_material_from_youngs_modulus()
template <class T>
status material_from_youngs_modulus(basic_pascals<T> youngs_modulus, detail::only<T> poisson_ratio,
                                    basic_material<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_material_from_youngs_modulus, youngs_modulus.value, poisson_ratio,
                           detail::out(&to));
}

/// kstrip_material_combine()
template <class T>
status combine(const basic_material<T> &lower, const basic_material<T> &upper,
               basic_combined_material<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_material_combine, detail::in(&lower), detail::in(&upper), detail::out(&to));
}

/// kstrip_hertz()
template <class T>
status hertz(const basic_radii<T> &curvatures, basic_newtons<T> normal_force,
             const basic_combined_material<T> &pair, basic_hertz_contact<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_hertz, detail::in(&curvatures), normal_force.value, detail::in(&pair),
                           detail::out(&to));
}

/// kstrip_creepage_from_velocities()
template <class T>
status creepage_from_velocities(const basic_velocity<T> &lower, const basic_velocity<T> &upper,
                                basic_metres_per_second<T> rolling_speed, basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_creepage_from_velocities, detail::in(&lower), detail::in(&upper),
                           rolling_speed.value, detail::out(&to));
}

/// kstrip_parameters_from_creepage()
template <class T>
status parameters_from_creepage(const basic_contact<T> &ellipse, const basic_creepage<T> &motion,
                                basic_parameters<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_parameters_from_creepage, detail::in(&ellipse), detail::in(&motion),
                           detail::out(&to));
}

/// kstrip_creepage_from_parameters()
template <class T>
status creepage_from_parameters(const basic_contact<T> &ellipse, const basic_parameters<T> &numbers,
                                basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_creepage_from_parameters, detail::in(&ellipse), detail::in(&numbers),
                           detail::out(&to));
}

/// kstrip_solve()
template <class T>
status solve(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
             basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve, detail::in(&ellipse), detail::in(&motion), detail::in(&how),
                           detail::out(&to));
}

/// kstrip_solve_jacobian()
template <class T>
status solve_jacobian(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
                      basic_result<T> &to, basic_jacobian<T> &slopes) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_jacobian, detail::in(&ellipse), detail::in(&motion),
                           detail::in(&how), detail::out(&to), slopes.value);
}

/// kstrip_solve_derivatives()
template <class T>
status solve_derivatives(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
                         basic_result<T> &to, basic_derivatives<T> &slopes) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_derivatives, detail::in(&ellipse), detail::in(&motion),
                           detail::in(&how), detail::out(&to), detail::out(&slopes));
}

/// kstrip_solve_friction(); `effective`, if not null, receives the friction that agrees with the slip.
template <class T>
status solve_friction(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const basic_friction<T> &law,
                      const options &how, basic_result<T> &to, T *effective = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_friction, detail::in(&ellipse), detail::in(&motion), detail::in(&law),
                           detail::in(&how), detail::out(&to), effective);
}

/// kstrip_solve_friction_jacobian()
template <class T>
status solve_friction_jacobian(const basic_contact<T> &ellipse, const basic_creepage<T> &motion,
                               const basic_friction<T> &law, const options &how, basic_result<T> &to,
                               basic_jacobian<T> &slopes, T *effective = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_friction_jacobian, detail::in(&ellipse), detail::in(&motion),
                           detail::in(&law), detail::in(&how), detail::out(&to), slopes.value, effective);
}

/// kstrip_contact_under_friction()
template <class T>
status under_friction(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const basic_friction<T> &law,
                      const options &how, basic_contact<T> &slipping) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_contact_under_friction, detail::in(&ellipse), detail::in(&motion),
                           detail::in(&law), detail::in(&how), detail::out(&slipping));
}

/// kstrip_estimate_friction()
template <class T>
status estimate_friction(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
                         measured which, basic_newtons<T> fx, basic_newtons<T> fy,
                         basic_friction_estimate<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_estimate_friction, detail::in(&ellipse), detail::in(&motion), detail::in(&how),
                           static_cast<std::uint32_t>(which), fx.value, fy.value, detail::out(&to));
}

/// kstrip_creepage_for_force()
template <class T>
status creepage_for_force(const basic_contact<T> &ellipse, basic_newtons<T> fx, basic_newtons<T> fy,
                          basic_per_metre<T> spin, const options &how, basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_creepage_for_force, detail::in(&ellipse), fx.value, fy.value, spin.value,
                           detail::in(&how), detail::out(&to));
}

/// kstrip_evaluate(); what is not wanted may be null.
template <class T>
status evaluate(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how, want wanted,
                basic_result<T> *to, basic_jacobian<T> *slopes = nullptr, basic_strip<T> *strips_to = nullptr,
                std::uint32_t capacity = 0, std::uint32_t *count = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_evaluate, detail::in(&ellipse), detail::in(&motion), detail::in(&how),
                           static_cast<std::uint32_t>(wanted), detail::out(to), slopes ? slopes->value : nullptr,
                           detail::out(strips_to), capacity, count);
}

/// kstrip_solve_total(), kstrip_solve_linear(), kstrip_solve_strip_1967(), kstrip_solve_strip(): programs that
/// call only these contain only the models that they name.
template <class T>
status solve_total(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_total, detail::in(&ellipse), detail::in(&motion), detail::out(&to));
}
template <class T>
status solve_linear(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_linear, detail::in(&ellipse), detail::in(&motion), detail::out(&to));
}
template <class T>
status solve_strip_1967(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, std::int32_t strips,
                        basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_strip_1967, detail::in(&ellipse), detail::in(&motion), strips,
                           detail::out(&to));
}
template <class T>
status solve_strip(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, std::int32_t strips,
                   basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_strip, detail::in(&ellipse), detail::in(&motion), strips,
                           detail::out(&to));
}

namespace detail {
template <class T>
status solve_batch(span<const basic_contact<T>> contacts, span<const basic_creepage<T>> creepages,
                   const options &how, span<basic_result<T>> to) noexcept
{
    if (contacts.size() != creepages.size() || contacts.size() > to.size() || !fits(contacts.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(T, kstrip_solve_batch, in(contacts.data()), in(creepages.data()),
                           static_cast<std::uint32_t>(contacts.size()), in(&how), out(to.data()));
}

template <class T>
status solve_jacobian_batch(span<const basic_contact<T>> contacts, span<const basic_creepage<T>> creepages,
                            const options &how, span<basic_result<T>> to, span<basic_jacobian<T>> slopes) noexcept
{
    if (contacts.size() != creepages.size() || contacts.size() > to.size() ||
        contacts.size() > slopes.size() || !fits(contacts.size()))
        return status::error_capacity;
    static_assert(sizeof(basic_jacobian<T>) == 9 * sizeof(T), "nine numbers");
    return KSTRIP_HPP_CALL(T, kstrip_solve_jacobian_batch, in(contacts.data()), in(creepages.data()),
                           static_cast<std::uint32_t>(contacts.size()), in(&how), out(to.data()),
                           reinterpret_cast<T *>(slopes.data()));
}

template <class T>
status strips(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
              span<basic_strip<T>> to, std::uint32_t &count) noexcept
{
    const auto capacity = static_cast<std::uint32_t>(fits(to.size()) ? to.size() : 0xffffffffu);
    return KSTRIP_HPP_CALL(T, kstrip_strips, in(&ellipse), in(&motion), in(&how), out(to.data()), capacity,
                           &count);
}

template <class T>
status field(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
             span<const basic_metres<T>> x, span<const basic_metres<T>> y, span<basic_point<T>> to) noexcept
{
    if (!fits(x.size()) || !fits(y.size()))
        return status::error_capacity;
    const auto capacity = static_cast<std::uint32_t>(fits(to.size()) ? to.size() : 0xffffffffu);
    return KSTRIP_HPP_CALL(T, kstrip_field, in(&ellipse), in(&motion), in(&how), in(x.data()),
                           static_cast<std::uint32_t>(x.size()), in(y.data()),
                           static_cast<std::uint32_t>(y.size()), out(to.data()), capacity);
}
} // namespace detail

/// kstrip_solve_batch(). Arrays of different sizes, or a smaller one for the results: error_capacity.
inline status solve_batch(span<const contact> contacts, span<const creepage> creepages, const options &how,
                          span<result> to) noexcept
{
    return detail::solve_batch<double>(contacts, creepages, how, to);
}
inline status solve_batch(span<const contact_f32> contacts, span<const creepage_f32> creepages,
                          const options &how, span<result_f32> to) noexcept
{
    return detail::solve_batch<float>(contacts, creepages, how, to);
}

/// kstrip_solve_jacobian_batch(). Sizes as for solve_batch().
inline status solve_jacobian_batch(span<const contact> contacts, span<const creepage> creepages,
                                   const options &how, span<result> to, span<jacobian> slopes) noexcept
{
    return detail::solve_jacobian_batch<double>(contacts, creepages, how, to, slopes);
}
inline status solve_jacobian_batch(span<const contact_f32> contacts, span<const creepage_f32> creepages,
                                   const options &how, span<result_f32> to, span<jacobian_f32> slopes) noexcept
{
    return detail::solve_jacobian_batch<float>(contacts, creepages, how, to, slopes);
}

/// kstrip_strips(): writes the first `count` elements; strips_capacity of them are always enough.
inline status strips(const contact &ellipse, const creepage &motion, const options &how, span<strip> to,
                     std::uint32_t &count) noexcept
{
    return detail::strips<double>(ellipse, motion, how, to, count);
}
inline status strips(const contact_f32 &ellipse, const creepage_f32 &motion, const options &how,
                     span<strip_f32> to, std::uint32_t &count) noexcept
{
    return detail::strips<float>(ellipse, motion, how, to, count);
}

/// kstrip_solve_batch_arrays()
template <class T>
status solve_batch_arrays(std::uint32_t count, const basic_batch_inputs<T> &from, const options &how,
                          const basic_batch_outputs<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_solve_batch_arrays, count, detail::in(&from), detail::in(&how), detail::in(&to));
}

/// kstrip_traction_at()
template <class T>
status traction_at(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how,
                   basic_metres<T> x, basic_metres<T> y, basic_point<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_traction_at, detail::in(&ellipse), detail::in(&motion), detail::in(&how),
                           x.value, y.value, detail::out(&to));
}

/// kstrip_field(): the point (x[i], y[j]) is to[j * x.size() + i].
inline status field(const contact &ellipse, const creepage &motion, const options &how,
                    span<const metres> x, span<const metres> y, span<point> to) noexcept
{
    return detail::field<double>(ellipse, motion, how, x, y, to);
}
inline status field(const contact_f32 &ellipse, const creepage_f32 &motion, const options &how,
                    span<const metres_f32> x, span<const metres_f32> y, span<point_f32> to) noexcept
{
    return detail::field<float>(ellipse, motion, how, x, y, to);
}

/// kstrip_result_on_upper_body(): it cannot fail here.
template <class T>
basic_result<T> on_upper_body(const basic_result<T> &lower) noexcept
{
    basic_result<T> upper{};
    static_cast<void>(KSTRIP_HPP_CALL(T, kstrip_result_on_upper_body, detail::in(&lower), detail::out(&upper)));
    return upper;
}

// ---- Patches of any shape ---------------------------------------------------------------------

/// kstrip_patch_from_ellipse()
template <class T>
status patch_from_ellipse(const basic_contact<T> &ellipse, std::int32_t count, basic_patch<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_from_ellipse, detail::in(&ellipse), count, detail::out(&to));
}

namespace detail {
template <class T>
status patch_from_strips(span<const basic_patch_strip<T>> from, basic_pascals<T> shear_modulus, T poisson_ratio,
                         basic_patch<T> &to) noexcept
{
    if (!fits(from.size()))
        return status::error_patch_size;
    return KSTRIP_HPP_CALL(T, kstrip_patch_from_strips, in(from.data()), static_cast<std::uint32_t>(from.size()),
                           shear_modulus.value, poisson_ratio, out(&to));
}

template <class T>
status patch_from_profile(span<const basic_metres<T>> y, span<const basic_metres<T>> distance,
                          const basic_profile_contact<T> &load, std::int32_t count, basic_patch<T> &to,
                          basic_profile_result<T> &how_they_meet) noexcept
{
    if (y.size() != distance.size() || !fits(y.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(T, kstrip_patch_from_profile, in(y.data()), in(distance.data()),
                           static_cast<std::uint32_t>(y.size()), in(&load), count, out(&to), out(&how_they_meet));
}

template <class T>
status patch_strips(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how,
                    span<basic_strip<T>> to, std::uint32_t &count) noexcept
{
    const auto capacity = static_cast<std::uint32_t>(fits(to.size()) ? to.size() : 0xffffffffu);
    return KSTRIP_HPP_CALL(T, kstrip_patch_strips, in(&area), in(&motion), in(&how), out(to.data()), capacity,
                           &count);
}

template <class T>
status patch_field(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how,
                   span<const basic_metres<T>> x, span<const basic_metres<T>> y, span<basic_point<T>> to) noexcept
{
    if (!fits(x.size()) || !fits(y.size()))
        return status::error_capacity;
    const auto capacity = static_cast<std::uint32_t>(fits(to.size()) ? to.size() : 0xffffffffu);
    return KSTRIP_HPP_CALL(T, kstrip_patch_field, in(&area), in(&motion), in(&how), in(x.data()),
                           static_cast<std::uint32_t>(x.size()), in(y.data()),
                           static_cast<std::uint32_t>(y.size()), out(to.data()), capacity);
}
} // namespace detail

/// kstrip_patch_from_strips()
inline status patch_from_strips(span<const patch_strip> from, pascals shear_modulus, double poisson_ratio,
                                patch &to) noexcept
{
    return detail::patch_from_strips<double>(from, shear_modulus, poisson_ratio, to);
}
inline status patch_from_strips(span<const patch_strip_f32> from, pascals_f32 shear_modulus, float poisson_ratio,
                                patch_f32 &to) noexcept
{
    return detail::patch_from_strips<float>(from, shear_modulus, poisson_ratio, to);
}

/// kstrip_patch_from_profile(). Arrays of different sizes: error_capacity.
inline status patch_from_profile(span<const metres> y, span<const metres> distance, const profile_contact &load,
                                 std::int32_t count, patch &to, profile_result &how_they_meet) noexcept
{
    return detail::patch_from_profile<double>(y, distance, load, count, to, how_they_meet);
}
inline status patch_from_profile(span<const metres_f32> y, span<const metres_f32> distance,
                                 const profile_contact_f32 &load, std::int32_t count, patch_f32 &to,
                                 profile_result_f32 &how_they_meet) noexcept
{
    return detail::patch_from_profile<float>(y, distance, load, count, to, how_they_meet);
}

/// kstrip_patch_summarize()
template <class T>
status summarize(const basic_patch<T> &area, basic_patch_summary<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_summarize, detail::in(&area), detail::out(&to));
}

/// kstrip_patch_solve()
template <class T>
status solve(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how,
             basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_solve, detail::in(&area), detail::in(&motion), detail::in(&how),
                           detail::out(&to));
}

/// kstrip_patch_jacobian()
template <class T>
status solve_jacobian(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how,
                      basic_result<T> &to, basic_jacobian<T> &slopes) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_jacobian, detail::in(&area), detail::in(&motion), detail::in(&how),
                           detail::out(&to), slopes.value);
}

/// kstrip_patch_solve_friction(); `share`, if not null, receives the share of friction that is left.
template <class T>
status solve_friction(const basic_patch<T> &area, const basic_creepage<T> &motion, const basic_friction<T> &law,
                      const options &how, basic_result<T> &to, T *share = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_solve_friction, detail::in(&area), detail::in(&motion), detail::in(&law),
                           detail::in(&how), detail::out(&to), share);
}

/// kstrip_patch_solve_friction_jacobian()
template <class T>
status solve_friction_jacobian(const basic_patch<T> &area, const basic_creepage<T> &motion,
                               const basic_friction<T> &law, const options &how, basic_result<T> &to,
                               basic_jacobian<T> &slopes, T *share = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_solve_friction_jacobian, detail::in(&area), detail::in(&motion),
                           detail::in(&law), detail::in(&how), detail::out(&to), slopes.value, share);
}

/// kstrip_patch_under_friction()
template <class T>
status under_friction(const basic_patch<T> &area, const basic_creepage<T> &motion, const basic_friction<T> &law,
                      const options &how, basic_patch<T> &slipping, T *share = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_under_friction, detail::in(&area), detail::in(&motion), detail::in(&law),
                           detail::in(&how), detail::out(&slipping), share);
}

/// kstrip_patch_strips()
inline status strips(const patch &area, const creepage &motion, const options &how, span<strip> to,
                     std::uint32_t &count) noexcept
{
    return detail::patch_strips<double>(area, motion, how, to, count);
}
inline status strips(const patch_f32 &area, const creepage_f32 &motion, const options &how, span<strip_f32> to,
                     std::uint32_t &count) noexcept
{
    return detail::patch_strips<float>(area, motion, how, to, count);
}

/// kstrip_patch_traction_at()
template <class T>
status traction_at(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how,
                   basic_metres<T> x, basic_metres<T> y, basic_point<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(T, kstrip_patch_traction_at, detail::in(&area), detail::in(&motion), detail::in(&how),
                           x.value, y.value, detail::out(&to));
}

/// kstrip_patch_field()
inline status field(const patch &area, const creepage &motion, const options &how, span<const metres> x,
                    span<const metres> y, span<point> to) noexcept
{
    return detail::patch_field<double>(area, motion, how, x, y, to);
}
inline status field(const patch_f32 &area, const creepage_f32 &motion, const options &how,
                    span<const metres_f32> x, span<const metres_f32> y, span<point_f32> to) noexcept
{
    return detail::patch_field<float>(area, motion, how, x, y, to);
}

// ---- The same, returning their output and throwing --------------------------------------------

#if defined(KSTRIP_HPP_EXCEPTIONS)
template <class T>
basic_material<T> material_from_youngs_modulus(basic_pascals<T> youngs_modulus, detail::only<T> poisson_ratio)
{
    basic_material<T> to{};
    detail::check(material_from_youngs_modulus(youngs_modulus, poisson_ratio, to));
    return to;
}

template <class T>
basic_combined_material<T> combine(const basic_material<T> &lower, const basic_material<T> &upper)
{
    basic_combined_material<T> to{};
    detail::check(combine(lower, upper, to));
    return to;
}

template <class T>
basic_hertz_contact<T> hertz(const basic_radii<T> &curvatures, basic_newtons<T> normal_force,
                             const basic_combined_material<T> &pair)
{
    basic_hertz_contact<T> to{};
    detail::check(hertz(curvatures, normal_force, pair, to));
    return to;
}

template <class T>
basic_creepage<T> creepage_from_velocities(const basic_velocity<T> &lower, const basic_velocity<T> &upper,
                                           basic_metres_per_second<T> rolling_speed)
{
    basic_creepage<T> to{};
    detail::check(creepage_from_velocities(lower, upper, rolling_speed, to));
    return to;
}

template <class T>
basic_parameters<T> parameters_from_creepage(const basic_contact<T> &ellipse, const basic_creepage<T> &motion)
{
    basic_parameters<T> to{};
    detail::check(parameters_from_creepage(ellipse, motion, to));
    return to;
}

template <class T>
basic_creepage<T> creepage_from_parameters(const basic_contact<T> &ellipse, const basic_parameters<T> &numbers)
{
    basic_creepage<T> to{};
    detail::check(creepage_from_parameters(ellipse, numbers, to));
    return to;
}

/// The forces; their warning, if any, is in status_detail.
template <class T>
basic_result<T> solve(const basic_contact<T> &ellipse, const basic_creepage<T> &motion, const options &how = {})
{
    basic_result<T> to{};
    detail::check(solve(ellipse, motion, how, to));
    return to;
}

template <class T>
basic_result<T> solve(const basic_patch<T> &area, const basic_creepage<T> &motion, const options &how = {})
{
    basic_result<T> to{};
    detail::check(solve(area, motion, how, to));
    return to;
}

template <class T>
basic_linearised<T> solve_jacobian(const basic_contact<T> &ellipse, const basic_creepage<T> &motion,
                                   const options &how = {})
{
    basic_linearised<T> to{};
    detail::check(solve_jacobian(ellipse, motion, how, to.result, to.jacobian));
    return to;
}

template <class T>
basic_point<T> traction_at(const basic_contact<T> &ellipse, const basic_creepage<T> &motion,
                           const options &how, basic_metres<T> x, basic_metres<T> y)
{
    basic_point<T> to{};
    detail::check(traction_at(ellipse, motion, how, x, y, to));
    return to;
}
#endif

#undef KSTRIP_HPP_CALL
} // namespace kstrip

#endif // KSTRIP_HPP
