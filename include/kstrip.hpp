/**
 * @file kstrip.hpp
 * kstrip for C++17 and later: the functions of kstrip.h, with units in the types.
 *
 * Every structure here has the layout of its C namesake, every function is one call of its C namesake:
 * see kstrip.h for axes, signs, ranges and statuses. Each function has two forms:
 *
 * - One form has the outputs as last arguments, returns kstrip::status and never throws.
 * - The other form returns the outputs and throws kstrip::error if the status is negative. It does not exist where exceptions are
 *   switched off. Options and falling friction are its last arguments and may be left out; arrays are returned as std::vector.
 *
 * Where a function takes lengths, they may be arrays, vectors or spans of kstrip::metres or of plain numbers in metres.
 *
 * `contact`, `creepage`, `6.0_mm` are in double precision, `contact_f32`, `creepage_f32`, `6.0_mm_f32` in single.
 */
#ifndef KSTRIP_HPP
#define KSTRIP_HPP

#include "kstrip.h"
#include "kstrip_f32.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <utility>

#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
#define KSTRIP_HPP_EXCEPTIONS 1
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <memory>
#include <string>
#include <system_error>
#include <vector>
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
    warning_pressure = KSTRIP_WARNING_PRESSURE,
    warning_creepage = KSTRIP_WARNING_CREEPAGE,
    warning_semi_axis = KSTRIP_WARNING_SEMI_AXIS,
    warning_spin_unit = KSTRIP_WARNING_SPIN_UNIT,
    warning_friction = KSTRIP_WARNING_FRICTION,
    warning_radius = KSTRIP_WARNING_RADIUS,
    warning_axis_ratio = KSTRIP_WARNING_AXIS_RATIO,
    warning_mismatch = KSTRIP_WARNING_MISMATCH,
    warning_mismatch_neglected = KSTRIP_WARNING_MISMATCH_NEGLECTED,
    warning_conformal = KSTRIP_WARNING_CONFORMAL,
    warning_angle_range = KSTRIP_WARNING_ANGLE_RANGE,
    warning_profile_end = KSTRIP_WARNING_PROFILE_END,
    warning_undetermined = KSTRIP_WARNING_UNDETERMINED,
    warning_orientation = KSTRIP_WARNING_ORIENTATION,
    warning_profile_size = KSTRIP_WARNING_PROFILE_SIZE,
    warning_modulus = KSTRIP_WARNING_MODULUS,
    warning_unset = KSTRIP_WARNING_UNSET,
    warning_support = KSTRIP_WARNING_SUPPORT,
    warning_profile_coarse = KSTRIP_WARNING_PROFILE_COARSE,
    warning_rough = KSTRIP_WARNING_ROUGH,
    warning_curvature = KSTRIP_WARNING_CURVATURE,
    warning_young = KSTRIP_WARNING_YOUNG,
    warning_per_cent = KSTRIP_WARNING_PER_CENT,
    warning_damping = KSTRIP_WARNING_DAMPING,
    warning_second_minimum = KSTRIP_WARNING_SECOND_MINIMUM,
    warning_fit_bound = KSTRIP_WARNING_FIT_BOUND,
    warning_profile_guess = KSTRIP_WARNING_PROFILE_GUESS,
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
    error_not_prepared = KSTRIP_ERROR_NOT_PREPARED,
    error_floor_speed = KSTRIP_ERROR_FLOOR_SPEED,
    error_stride = KSTRIP_ERROR_STRIDE,
    error_slide_factor = KSTRIP_ERROR_SLIDE_FACTOR,
    error_layer = KSTRIP_ERROR_LAYER,
    error_few_points = KSTRIP_ERROR_FEW_POINTS,
    error_fit_parameters = KSTRIP_ERROR_FIT_PARAMETERS,
    error_weight = KSTRIP_ERROR_WEIGHT,
    error_model_left_out = KSTRIP_ERROR_MODEL_LEFT_OUT,
    error_modulus_unit = KSTRIP_ERROR_MODULUS_UNIT,
    error_strip_size = KSTRIP_ERROR_STRIP_SIZE,
    error_pressure = KSTRIP_ERROR_PRESSURE,
    error_strip_order = KSTRIP_ERROR_STRIP_ORDER,
    error_patch_size = KSTRIP_ERROR_PATCH_SIZE,
    error_profile = KSTRIP_ERROR_PROFILE,
    error_profile_end = KSTRIP_ERROR_PROFILE_END,
    error_rolling_radius = KSTRIP_ERROR_ROLLING_RADIUS,
    error_smoothing_length = KSTRIP_ERROR_SMOOTHING_LENGTH,
    error_scatter = KSTRIP_ERROR_SCATTER,
    error_normal_damping = KSTRIP_ERROR_NORMAL_DAMPING,
    error_share = KSTRIP_ERROR_SHARE,
    error_support = KSTRIP_ERROR_SUPPORT,
    error_angle = KSTRIP_ERROR_ANGLE,
    error_length_unit = KSTRIP_ERROR_LENGTH_UNIT,
    error_swapped = KSTRIP_ERROR_SWAPPED,
    error_orientation = KSTRIP_ERROR_ORIENTATION,
    error_gauge = KSTRIP_ERROR_GAUGE,
    error_wheel_lifted = KSTRIP_ERROR_WHEEL_LIFTED,
    error_conicity = KSTRIP_ERROR_CONICITY,
    error_file_format = KSTRIP_ERROR_FILE_FORMAT,
    error_file_line = KSTRIP_ERROR_FILE_LINE,
    error_file_columns = KSTRIP_ERROR_FILE_COLUMNS,
    error_file_count = KSTRIP_ERROR_FILE_COUNT,
    error_file_units = KSTRIP_ERROR_FILE_UNITS,
    error_file_missing = KSTRIP_ERROR_FILE_MISSING,
    error_slice_share = KSTRIP_ERROR_SLICE_SHARE,
    error_table = KSTRIP_ERROR_TABLE,
    error_table_unfinished = KSTRIP_ERROR_TABLE_UNFINISHED,
    error_table_pair = KSTRIP_ERROR_TABLE_PAIR,
    error_table_spec = KSTRIP_ERROR_TABLE_SPEC,
    error_table_range = KSTRIP_ERROR_TABLE_RANGE,
};

constexpr bool is_error(status s) noexcept { return static_cast<std::int32_t>(s) < 0; }
constexpr bool is_warning(status s) noexcept { return static_cast<std::int32_t>(s) > 0; }
/// The cause of the status and the remedy.
inline const char *to_string(status s) noexcept { return kstrip_status_string(static_cast<kstrip_status>(s)); }

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// Thrown by the functions that return their output.
class error : public std::exception {
public:
    explicit error(kstrip::status s, std::size_t index = 0) noexcept : status_(s), index_(index) {}
    kstrip::status status() const noexcept { return status_; }
    /// For many contacts, wheels or amplitudes in one call the index of the first one with an error; otherwise 0.
    std::size_t index() const noexcept { return index_; }
    const char *what() const noexcept override { return to_string(status_); }

private:
    kstrip::status status_;
    std::size_t index_;
};
#endif

// ---- Units ------------------------------------------------------------------------------------

namespace detail {
template <class> inline constexpr bool never = false;
template <class X> struct only_type { using type = X; };
/// A parameter that follows the precision of the others.
template <class X> using only = typename only_type<X>::type;
} // namespace detail

/// A number with a unit. A plain number converts to it only explicitly, and `value` converts it back.
template <class Unit, class T>
struct quantity {
    T value{};

    constexpr quantity() noexcept = default;
    template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
    constexpr explicit quantity(Number number) noexcept : value(static_cast<T>(number)) {}
    /// A number without its unit does not compile; this constructor gives the reason.
    template <class Number, class... None,
              class = std::enable_if_t<std::is_arithmetic_v<Number> && sizeof...(None) == 0>>
    constexpr quantity(Number, None...) noexcept
    {
        static_assert(detail::never<Number>, "a number lacks its unit: 6.0_mm, 80_kN, 82_GPa, spin 0.4_per_m");
    }
    /// Another unit or precision.
    template <class Other, class S>
    constexpr quantity(quantity<Other, S>) noexcept
    {
        static_assert(std::is_same_v<Unit, Other>, "a quantity has another unit");
        static_assert(detail::never<S>, "a quantity has another precision: 6.0_mm_f32 is single, 6.0_mm double");
    }

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

#define KSTRIP_HPP_UNIT(name)                                                                     \
    namespace unit { struct name; }                                                               \
    template <class T> using basic_##name = quantity<unit::name, T>;                              \
    using name = basic_##name<double>;                                                            \
    using name##_f32 = basic_##name<float>;
KSTRIP_HPP_UNIT(metres)
KSTRIP_HPP_UNIT(newtons)
KSTRIP_HPP_UNIT(pascals)
KSTRIP_HPP_UNIT(per_metre)
KSTRIP_HPP_UNIT(newton_metres)
KSTRIP_HPP_UNIT(radians)
KSTRIP_HPP_UNIT(metres_per_second)
KSTRIP_HPP_UNIT(radians_per_second)
KSTRIP_HPP_UNIT(seconds_per_metre)
KSTRIP_HPP_UNIT(square_metres)
KSTRIP_HPP_UNIT(per_newton)
KSTRIP_HPP_UNIT(newtons_per_metre)
#undef KSTRIP_HPP_UNIT

namespace detail {
/// The unit of a product: `product<unit::newtons, unit::metres>::type` is unit::newton_metres.
template <class First, class Second> struct product {};
#define KSTRIP_HPP_PRODUCT(first, second, result)                                                 \
    template <> struct product<unit::first, unit::second> { using type = unit::result; };
#define KSTRIP_HPP_PRODUCTS(first, second, result)                                                \
    KSTRIP_HPP_PRODUCT(first, second, result)                                                     \
    KSTRIP_HPP_PRODUCT(second, first, result)
KSTRIP_HPP_PRODUCTS(newtons, metres, newton_metres)
KSTRIP_HPP_PRODUCT(metres, metres, square_metres)
KSTRIP_HPP_PRODUCTS(pascals, square_metres, newtons)
KSTRIP_HPP_PRODUCTS(newtons_per_metre, metres, newtons)
KSTRIP_HPP_PRODUCTS(radians_per_second, metres, metres_per_second)
KSTRIP_HPP_PRODUCTS(per_metre, metres_per_second, radians_per_second)
#undef KSTRIP_HPP_PRODUCTS
#undef KSTRIP_HPP_PRODUCT
} // namespace detail

/// A force times a lever is a moment, a pressure times an area a force, and so on.
template <class First, class Second, class T, class Unit = typename detail::product<First, Second>::type>
constexpr quantity<Unit, T> operator*(quantity<First, T> p, quantity<Second, T> q) noexcept
{
    return quantity<Unit, T>(p.value * q.value);
}

/// `6.0_mm`, `80_kN`, `82_GPa`, `0.4_per_m`, `20_m_per_s`, `2.5_mrad`; in single precision `6.0_mm_f32`. Write `using namespace
/// kstrip::literals;` first.
inline namespace literals {
#define KSTRIP_HPP_LITERAL_OF(suffix, type, divisor, factor)                                      \
    constexpr type operator""_##suffix(long double v) noexcept { return type(v * factor / divisor); } \
    constexpr type operator""_##suffix(unsigned long long v) noexcept                             \
    {                                                                                             \
        return type(static_cast<long double>(v) * factor / divisor);                              \
    }
#define KSTRIP_HPP_LITERAL(suffix, type, divisor, factor)                                         \
    KSTRIP_HPP_LITERAL_OF(suffix, type, divisor, factor)                                          \
    KSTRIP_HPP_LITERAL_OF(suffix##_f32, type##_f32, divisor, factor)
KSTRIP_HPP_LITERAL(m, metres, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(mm, metres, 1e3L, 1.0L)
KSTRIP_HPP_LITERAL(N, newtons, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(kN, newtons, 1.0L, 1e3L)
KSTRIP_HPP_LITERAL(Pa, pascals, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(MPa, pascals, 1.0L, 1e6L)
KSTRIP_HPP_LITERAL(GPa, pascals, 1.0L, 1e9L)
KSTRIP_HPP_LITERAL(per_m, per_metre, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(Nm, newton_metres, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(kNm, newton_metres, 1.0L, 1e3L)
KSTRIP_HPP_LITERAL(N_per_m, newtons_per_metre, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(rad, radians, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(mrad, radians, 1e3L, 1.0L)
KSTRIP_HPP_LITERAL(deg, radians, 180.0L, 3.14159265358979323846264338327950288L)
KSTRIP_HPP_LITERAL(m_per_s, metres_per_second, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(km_per_h, metres_per_second, 3.6L, 1.0L)
KSTRIP_HPP_LITERAL(rad_per_s, radians_per_second, 1.0L, 1.0L)
KSTRIP_HPP_LITERAL(s_per_m, seconds_per_metre, 1.0L, 1.0L)
#undef KSTRIP_HPP_LITERAL
#undef KSTRIP_HPP_LITERAL_OF
} // namespace literals

// ---- Views, and the way to C ------------------------------------------------------------------

#if defined(__cpp_lib_span)
template <class T> using span = std::span<T>;
#else
/// A pointer and a size, for compilers without std::span.
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

namespace detail {
/// The precision of a number or quantity.
template <class X> struct precision { using type = X; };
template <class Unit, class T> struct precision<quantity<Unit, T>> { using type = T; };
/// The precision of the elements of an array, a vector, a span.
template <class C>
using precision_of =
    typename precision<std::remove_cv_t<std::remove_reference_t<decltype(*std::begin(std::declval<C &>()))>>>::type;
} // namespace detail

/// A sequence of numbers in caller-provided memory: arrays, vectors or spans of quantities with this unit, or of plain numbers, which
/// are taken as SI units (metres).
template <class Unit, class T>
class numbers {
public:
    constexpr numbers() noexcept = default;
    constexpr numbers(const T *data, std::size_t size) noexcept : data_(data), size_(size) {}
    numbers(const quantity<Unit, T> *data, std::size_t size) noexcept
        : data_(reinterpret_cast<const T *>(data)), size_(size)
    {}
    template <class X, std::size_t N, class = std::enable_if_t<std::is_same_v<X, T> || std::is_same_v<X, quantity<Unit, T>>>>
    numbers(const X (&array)[N]) noexcept : numbers(&array[0], N)
    {}
    template <class C, class X = std::remove_cv_t<std::remove_pointer_t<decltype(std::declval<const C &>().data())>>,
              class = std::enable_if_t<std::is_same_v<X, T> || std::is_same_v<X, quantity<Unit, T>>>>
    numbers(const C &contiguous) noexcept : numbers(contiguous.data(), contiguous.size())
    {}

    constexpr const T *data() const noexcept { return data_; }
    constexpr std::size_t size() const noexcept { return size_; }

private:
    static_assert(sizeof(quantity<Unit, T>) == sizeof(T) && std::is_standard_layout_v<quantity<Unit, T>>,
                  "a quantity is a number");
    const T *data_ = nullptr;
    std::size_t size_ = 0;
};
/// Lengths: `std::vector<double>` in metres, `std::vector<kstrip::metres>`, ...
template <class T> using lengths = numbers<unit::metres, T>;

namespace detail {
/// The C type of a C++ type: `twin<contact>::type` is kstrip_contact.
template <class Cpp> struct twin { using type = Cpp; };
template <class Unit, class T> struct twin<quantity<Unit, T>> { using type = T; };
template <class Cpp> struct twin<const Cpp> { using type = const typename twin<Cpp>::type; };

template <class X> constexpr X to_c(X number) noexcept { return number; }
template <class Unit, class T> constexpr T to_c(quantity<Unit, T> q) noexcept { return q.value; }
template <class X> auto to_c(X *p) noexcept { return reinterpret_cast<typename twin<X>::type *>(p); }

template <class F, class... A>
status call(F function, A... arguments) noexcept { return static_cast<status>(function(to_c(arguments)...)); }

/// The size of an array for C, where sizes have 32 bits. The elements beyond are not used.
constexpr std::uint32_t capacity(std::size_t size) noexcept
{
    return size > 0xffffffffu ? 0xffffffffu : static_cast<std::uint32_t>(size);
}
constexpr bool fits(std::size_t size) noexcept { return size <= 0xffffffffu; }

#if defined(KSTRIP_HPP_EXCEPTIONS)
inline void check(status s, std::size_t index = 0)
{
    if (is_error(s))
        throw error(s, index);
}

/// Calls a function that writes a status for each of `count` elements, and returns these statuses. Throws the error of the first
/// element that has one.
template <class Call>
std::vector<status> each_status(std::size_t count, Call function)
{
    std::vector<std::int32_t> written(count);
    const status s = function(span<std::int32_t>(written.data(), count));
    std::size_t first = 0;
    while (first < count && written[first] >= 0)
        ++first;
    check(s, first < count ? first : 0);
    std::vector<status> found(count);
    for (std::size_t i = 0; i < count; ++i)
        found[i] = static_cast<status>(written[i]);
    return found;
}
#endif
} // namespace detail

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// Results of many wheels, wheelsets or shifts in one call, with the status of each. A function that returns them throws the error of the
/// first element that has one; the form that does not throw writes the results of all other elements too.
template <class X>
struct results : std::vector<X> {
    using std::vector<X>::vector;
    std::vector<status> statuses; ///< of each element: ok or a warning
};
#endif

/// The function of C in the precision T.
#define KSTRIP_HPP_CALL(name, ...)                                                                \
    detail::call(                                                                                 \
        [](auto... argument) {                                                                    \
            if constexpr (std::is_same_v<T, double>)                                              \
                return name(argument...);                                                         \
            else                                                                                  \
                return name##_f32(argument...);                                                   \
        },                                                                                        \
        __VA_ARGS__)
#define KSTRIP_HPP_SAME(cpp, c)                                                                   \
    namespace detail { template <> struct twin<cpp> { using type = c; }; }                        \
    static_assert(sizeof(cpp) == sizeof(c) && alignof(cpp) == alignof(c), #cpp " has the layout of " #c); \
    static_assert(std::is_standard_layout_v<cpp> && std::is_trivially_copyable_v<cpp>, #cpp " is plain data");
#define KSTRIP_HPP_BOTH(name)                                                                     \
    using name = basic_##name<double>;                                                            \
    using name##_f32 = basic_##name<float>;                                                       \
    KSTRIP_HPP_SAME(name, kstrip_##name)                                                          \
    KSTRIP_HPP_SAME(name##_f32, kstrip_##name##_f32)
/// The body of the form that throws: outputs `to`, filled by `call`, are returned.
#define KSTRIP_HPP_THROWING(outputs, call, ...)                                                   \
    {                                                                                             \
        outputs to{};                                                                             \
        detail::check(call(__VA_ARGS__));                                                         \
        return to;                                                                                \
    }

// ---- Bodies: materials, Hertz's ellipse and its inverse, linear coefficients ------------------

/// An isotropic elastic body. See kstrip_material.
template <class T>
struct basic_material {
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
};
KSTRIP_HPP_BOTH(material)

/// The combined elastic constants of two bodies. See kstrip_combined_material.
template <class T>
struct basic_combined_material {
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T mismatch;
};
KSTRIP_HPP_BOTH(combined_material)

/// Radii of curvature of two bodies at the contact [m]. See kstrip_radii.
template <class T>
struct basic_radii {
    basic_metres<T> lower_x, lower_y, upper_x, upper_y;
};
KSTRIP_HPP_BOTH(radii)

/// A loaded elliptic contact with combined elastic constants and Coulomb friction. See kstrip_contact.
template <class T>
struct basic_contact {
    basic_metres<T> a, b;
    basic_newtons<T> normal_force;
    basic_pascals<T> shear_modulus;
    T poisson_ratio;
    T friction;
    T mismatch = 0; ///< of the two materials; 0: like ones
};
KSTRIP_HPP_BOTH(contact)

/// The contact ellipse of Hertz. See kstrip_hertz_contact.
template <class T>
struct basic_hertz_contact {
    basic_metres<T> a, b;
    basic_pascals<T> peak_pressure;
    basic_metres<T> approach;
    T axis_ratio;
    basic_radians<T> hertz_angle;
    basic_metres<T> rho;
};
KSTRIP_HPP_BOTH(hertz_contact)

/// Calls kstrip_material_combine().
template <class T>
status combine(const basic_material<T> &lower, const basic_material<T> &upper, basic_combined_material<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_material_combine, &lower, &upper, &to);
}

/// Calls kstrip_contact_from_hertz().
template <class T>
status contact_from_hertz(const basic_radii<T> &curvatures, const basic_combined_material<T> &pair,
                          detail::only<basic_newtons<T>> load, detail::only<T> friction, basic_contact<T> &to,
                          detail::only<basic_hertz_contact<T>> *ellipse = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_contact_from_hertz, &curvatures, &pair, load, friction, &to, ellipse);
}

/// Calls kstrip_contact_from_approach().
template <class T>
status contact_from_approach(const basic_radii<T> &curvatures, const basic_combined_material<T> &pair,
                             detail::only<basic_metres<T>> approach, detail::only<T> friction, basic_contact<T> &to,
                             detail::only<basic_newtons_per_metre<T>> *stiffness = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_contact_from_approach, &curvatures, &pair, approach, friction, &to, stiffness);
}

/// C11, C22, C23, C33
template <class T>
status linear_coefficients(T axis_ratio, detail::only<T> poisson_ratio, T (&to)[4]) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_linear_coefficients, axis_ratio, poisson_ratio, &to[0]);
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// The form of combine() that throws.
template <class T>
basic_combined_material<T> combine(const basic_material<T> &lower, const basic_material<T> &upper)
KSTRIP_HPP_THROWING(basic_combined_material<T>, combine, lower, upper, to)

/// Result of contact_from_hertz().
template <class T>
struct basic_hertz {
    basic_contact<T> contact;
    basic_hertz_contact<T> ellipse;
};
/// The form of contact_from_hertz() that throws.
template <class T>
basic_hertz<T> contact_from_hertz(const basic_radii<T> &curvatures, const basic_combined_material<T> &pair,
                                  detail::only<basic_newtons<T>> load, detail::only<T> friction)
KSTRIP_HPP_THROWING(basic_hertz<T>, contact_from_hertz, curvatures, pair, load, friction, to.contact, &to.ellipse)

/// Result of contact_from_approach().
template <class T>
struct basic_approach {
    basic_contact<T> contact;
    basic_newtons_per_metre<T> stiffness; ///< dN/d(approach)
};
/// The form of contact_from_approach() that throws.
template <class T>
basic_approach<T> contact_from_approach(const basic_radii<T> &curvatures, const basic_combined_material<T> &pair,
                                        detail::only<basic_metres<T>> approach, detail::only<T> friction)
KSTRIP_HPP_THROWING(basic_approach<T>, contact_from_approach, curvatures, pair, approach, friction, to.contact,
                    &to.stiffness)

/// C11, C22, C23, C33
template <class T>
std::array<T, 4> linear_coefficients(T axis_ratio, detail::only<T> poisson_ratio)
{
    T to[4];
    detail::check(linear_coefficients(axis_ratio, poisson_ratio, to));
    return {to[0], to[1], to[2], to[3]};
}
#endif

// ---- Motion: creepages, Kalker's parameters ---------------------------------------------------

/// Velocity of one body's material at the centre of the contact, relative to the contact. See kstrip_velocity.
template <class T>
struct basic_velocity {
    basic_metres_per_second<T> x, y;
    basic_radians_per_second<T> angular_z;
};
KSTRIP_HPP_BOTH(velocity)

/// Rigid slip of the upper relative to the lower body, divided by the rolling speed (3.3). See kstrip_creepage.
template <class T>
struct basic_creepage {
    T longitudinal, lateral;
    basic_per_metre<T> spin;
};
KSTRIP_HPP_BOTH(creepage)

/// Kalker's parameters (5.13) of a contact in motion, dimensionless. See kstrip_parameters.
template <class T>
struct basic_parameters {
    T xi, eta, psi;
};
KSTRIP_HPP_BOTH(parameters)

/// Calls kstrip_creepage_from_velocities().
template <class T>
status creepage_from_velocities(const basic_velocity<T> &lower, const basic_velocity<T> &upper,
                                detail::only<basic_metres_per_second<T>> rolling_speed, basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_creepage_from_velocities, &lower, &upper, rolling_speed, &to);
}

/// Calls kstrip_parameters_from_creepage().
template <class T>
status parameters_from_creepage(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &motion,
                                basic_parameters<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_parameters_from_creepage, &ellipse, &motion, &to);
}

/// Calls kstrip_creepage_from_parameters().
template <class T>
status creepage_from_parameters(const basic_contact<T> &ellipse, const detail::only<basic_parameters<T>> &numbers,
                                basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_creepage_from_parameters, &ellipse, &numbers, &to);
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// The form of creepage_from_velocities() that throws.
template <class T>
basic_creepage<T> creepage_from_velocities(const basic_velocity<T> &lower, const basic_velocity<T> &upper,
                                           detail::only<basic_metres_per_second<T>> rolling_speed)
KSTRIP_HPP_THROWING(basic_creepage<T>, creepage_from_velocities, lower, upper, rolling_speed, to)

/// The form of parameters_from_creepage() that throws.
template <class T>
basic_parameters<T> parameters_from_creepage(const basic_contact<T> &ellipse,
                                             const detail::only<basic_creepage<T>> &motion)
KSTRIP_HPP_THROWING(basic_parameters<T>, parameters_from_creepage, ellipse, motion, to)

/// The form of creepage_from_parameters() that throws.
template <class T>
basic_creepage<T> creepage_from_parameters(const basic_contact<T> &ellipse,
                                           const detail::only<basic_parameters<T>> &numbers)
KSTRIP_HPP_THROWING(basic_creepage<T>, creepage_from_parameters, ellipse, numbers, to)
#endif

// ---- Solve: forces, derivatives, strips -------------------------------------------------------

enum class model : std::int32_t {
    default_ = KSTRIP_MODEL_DEFAULT,
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

inline constexpr std::uint32_t strips_capacity = KSTRIP_STRIPS_CAPACITY;

/// Model and strip count; zero is the default.
struct options {
    kstrip::model model = kstrip::model::default_;
    std::int32_t strips = 0;
};
KSTRIP_HPP_SAME(options, kstrip_options)

/// Forces on the lower body.
template <class T>
struct basic_result {
    basic_newtons<T> fx, fy;
    basic_newton_metres<T> mz;
    basic_newtons<T> power; ///< power divided by rolling speed: joules per metre rolled
    T adhesion;
    kstrip::status status_detail;
    std::int32_t reserved;
    /// fx, fy, 0 [N], 0, 0, mz [N m]
    constexpr operator std::array<T, 6>() const noexcept { return {fx.value, fy.value, T(0), T(0), T(0), mz.value}; }
};
KSTRIP_HPP_BOTH(result)

/// Falling friction, and the stiffness of the layer; friction{mu} is constant.
template <class T>
struct basic_friction {
    T friction;
    T ratio = T(1);
    basic_seconds_per_metre<T> decay{};
    basic_metres_per_second<T> rolling_speed{};
    T slope_factor = T(1);
    T slide_factor{};
    T layer{};
};
KSTRIP_HPP_BOTH(friction)

/// Derivatives of fx, fy, mz.
template <class T>
struct basic_derivatives {
    T jacobian[3][3]; ///< with respect to longitudinal, lateral, spin, row by row
    T normal_force[3];
    T load_through_hertz[3];
    T friction[3];
};
KSTRIP_HPP_BOTH(derivatives)

/// Derivatives of fx, fy, mz with respect to the parameters of falling friction. See kstrip_law_derivatives.
template <class T>
struct basic_law_derivatives {
    T ratio[3];
    T decay[3];
    T rolling_speed[3];
    T slope_factor[3];
    T slide_factor[3];
    T layer[3];
};
KSTRIP_HPP_BOTH(law_derivatives)

/// One strip y = const of a contact or a patch, and the forces that it carries on the lower body. See kstrip_strip.
template <class T>
struct basic_strip {
    basic_metres<T> y, width, half_length, separatrix;
    basic_newtons<T> fx, fy;
    basic_newton_metres<T> mz;
    basic_newtons<T> power;
    kstrip::state state;
    std::int32_t reserved;
};
KSTRIP_HPP_BOTH(strip)

/// Where the outputs of evaluate() go; an output that is null is not computed.
template <class T>
struct basic_outputs {
    basic_result<T> *result = nullptr;
    basic_derivatives<T> *derivatives = nullptr;
    basic_law_derivatives<T> *law_derivatives = nullptr;
    T *friction = nullptr;
    basic_strip<T> *strips = nullptr;
    std::uint32_t *count = nullptr;
    std::uint32_t capacity = 0;
    std::uint32_t reserved = 0;
};
KSTRIP_HPP_BOTH(outputs)

/// Pointers to the first of each quantity and distances to the next in bytes; see batch_of().
template <class T>
struct basic_batch_inputs {
    const basic_metres<T> *a = nullptr;
    std::ptrdiff_t a_stride = 0;
    const basic_metres<T> *b = nullptr;
    std::ptrdiff_t b_stride = 0;
    const basic_newtons<T> *normal_force = nullptr;
    std::ptrdiff_t normal_force_stride = 0;
    const basic_pascals<T> *shear_modulus = nullptr;
    std::ptrdiff_t shear_modulus_stride = 0;
    const T *poisson_ratio = nullptr;
    std::ptrdiff_t poisson_ratio_stride = 0;
    const T *friction = nullptr;
    std::ptrdiff_t friction_stride = 0;
    const T *mismatch = nullptr; ///< null: like materials
    std::ptrdiff_t mismatch_stride = 0;
    const T *longitudinal = nullptr;
    std::ptrdiff_t longitudinal_stride = 0;
    const T *lateral = nullptr;
    std::ptrdiff_t lateral_stride = 0;
    const basic_per_metre<T> *spin = nullptr;
    std::ptrdiff_t spin_stride = 0;
    const basic_friction<T> *law = nullptr;
    std::ptrdiff_t law_stride = 0;
};
KSTRIP_HPP_BOTH(batch_inputs)

/// Where the results of a batch go; null if a quantity is not needed.
template <class T>
struct basic_batch_outputs {
    basic_newtons<T> *fx = nullptr;
    std::ptrdiff_t fx_stride = 0;
    basic_newtons<T> *fy = nullptr;
    std::ptrdiff_t fy_stride = 0;
    basic_newton_metres<T> *mz = nullptr;
    std::ptrdiff_t mz_stride = 0;
    basic_newtons<T> *power = nullptr;
    std::ptrdiff_t power_stride = 0;
    T *adhesion = nullptr;
    std::ptrdiff_t adhesion_stride = 0;
    kstrip::status *status_detail = nullptr;
    std::ptrdiff_t status_detail_stride = 0;
    T *friction = nullptr;
    std::ptrdiff_t friction_stride = 0;
    basic_derivatives<T> *derivatives = nullptr;
    std::ptrdiff_t derivatives_stride = 0;
    basic_law_derivatives<T> *law_derivatives = nullptr;
    std::ptrdiff_t law_derivatives_stride = 0;
};
KSTRIP_HPP_BOTH(batch_outputs)

/// A contact for which everything that does not depend on the motion has been computed.
template <class T>
struct basic_prepared {
    T numbers[96];
    kstrip::model model;
    std::int32_t strips;
};
KSTRIP_HPP_BOTH(prepared)

/// Slip, spin rate and signed rolling speed, in axes that stay when the motion reverses.
template <class T>
struct basic_motion {
    basic_metres_per_second<T> slip_x, slip_y;
    basic_radians_per_second<T> spin_rate;
    basic_metres_per_second<T> rolling_speed;
    basic_metres_per_second<T> floor_speed{}; ///< 0: 0.02 m/s
};
KSTRIP_HPP_BOTH(motion)

/// Derivatives of fx, fy, mz with respect to motion, load and friction. See kstrip_motion_derivatives.
template <class T>
struct basic_motion_derivatives {
    T slip[3][3]; ///< with respect to slip_x, slip_y, spin_rate, row by row
    T rolling_speed[3];
    T normal_force[3];
    T load_through_hertz[3];
    T friction[3];
    T ratio[3];
    T decay[3];
    T slope_factor[3];
    T slide_factor[3];
    T layer[3];
};
KSTRIP_HPP_BOTH(motion_derivatives)

/// Where the outputs of solve_motion() go; an output that is null is not computed.
template <class T>
struct basic_motion_outputs {
    basic_result<T> *result = nullptr;
    basic_motion_derivatives<T> *derivatives = nullptr;
    T *friction = nullptr;
};
KSTRIP_HPP_BOTH(motion_outputs)

/// Calls kstrip_solve().
template <class T>
status solve(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep, const options &how,
             basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve, &ellipse, &creep, &how, &to);
}

/// `law`: null if friction is constant.
template <class T>
status evaluate(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                const detail::only<basic_friction<T>> *law, const options &how,
                const detail::only<basic_outputs<T>> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_evaluate, &ellipse, &creep, law, &how, &to);
}

/// Calls kstrip_evaluate_batch().
template <class T>
status evaluate_batch(const basic_batch_inputs<T> &from, std::uint32_t count, const options &how,
                      const basic_batch_outputs<T> &to, std::uint32_t *first_bad = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_evaluate_batch, &from, count, &how, &to, first_bad);
}

/// The inputs of a batch from the first contact and the first creepage of two arrays.
template <class T>
basic_batch_inputs<T> batch_of(const basic_contact<T> *contacts, const basic_creepage<T> *creepages) noexcept
{
    constexpr std::ptrdiff_t c = sizeof(basic_contact<T>), m = sizeof(basic_creepage<T>);
    return {&contacts->a, c, &contacts->b, c, &contacts->normal_force, c, &contacts->shear_modulus, c,
            &contacts->poisson_ratio, c, &contacts->friction, c, &contacts->mismatch, c, &creepages->longitudinal, m,
            &creepages->lateral, m, &creepages->spin, m, nullptr, 0};
}
/// The outputs of a batch into an array of results.
template <class T>
basic_batch_outputs<T> batch_of(basic_result<T> *results) noexcept
{
    constexpr std::ptrdiff_t r = sizeof(basic_result<T>);
    return {&results->fx, r, &results->fy, r, &results->mz, r, &results->power, r, &results->adhesion, r,
            &results->status_detail, r, nullptr, 0, nullptr, 0, nullptr, 0};
}

/// Calls kstrip_prepare().
template <class T>
status prepare(const basic_contact<T> &ellipse, const options &how, basic_prepared<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_prepare, &ellipse, &how, &to);
}

/// Calls kstrip_solve_prepared().
template <class T>
status solve(const basic_prepared<T> &ready, const detail::only<basic_creepage<T>> &creep, basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_prepared, &ready, &creep, &to);
}

/// Calls kstrip_solve_motion().
template <class T>
status solve_motion(const basic_contact<T> &ellipse, const detail::only<basic_motion<T>> &moving,
                    const detail::only<basic_friction<T>> *law, const options &how,
                    const detail::only<basic_motion_outputs<T>> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_motion, &ellipse, &moving, law, &how, &to);
}

/// Each of these functions links one model alone.
template <class T>
status solve_total(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                   basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_total, &ellipse, &creep, &to);
}
/// Calls kstrip_solve_strip().
template <class T>
status solve_strip(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep, std::int32_t strips,
                   basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_strip, &ellipse, &creep, strips, &to);
}
/// Calls kstrip_solve_strip_1967().
template <class T>
status solve_strip_1967(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                        std::int32_t strips, basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_strip_1967, &ellipse, &creep, strips, &to);
}
/// Calls kstrip_solve_linear().
template <class T>
status solve_linear(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                    basic_result<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_solve_linear, &ellipse, &creep, &to);
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// Result of evaluate().
template <class T>
struct basic_evaluation {
    basic_result<T> result;
    basic_derivatives<T> derivatives;
    basic_law_derivatives<T> law_derivatives;
    T friction;
    operator basic_outputs<T>() noexcept { return {&result, &derivatives, &law_derivatives, &friction}; }
};
/// Result of solve_motion().
template <class T>
struct basic_motion_solution {
    basic_result<T> result;
    basic_motion_derivatives<T> derivatives;
    T friction;
    operator basic_motion_outputs<T>() noexcept { return {&result, &derivatives, &friction}; }
};

/// The forces; their warning, if any, is in status_detail.
template <class T>
basic_result<T> solve(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                      const options &how = {})
KSTRIP_HPP_THROWING(basic_result<T>, solve, ellipse, creep, how, to)

/// Forces, derivatives and the friction that agrees with the slip.
template <class T>
basic_evaluation<T> evaluate(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                             const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_evaluation<T>, evaluate, ellipse, creep, law, how, to)

namespace detail {
/// A batch of `count` creepages into the outputs; one contact for all, or as many as creepages.
template <class Contacts, class Creepages, class T>
void run_batch(const Contacts &contacts, const Creepages &creepages, const options &how, const basic_friction<T> *law,
               const basic_batch_outputs<T> &to)
{
    const std::size_t count = creepages.size();
    if ((contacts.size() != 1 && contacts.size() != count) || !fits(count))
        throw error(status::error_capacity);
    if (count == 0)
        return;
    basic_batch_inputs<T> from = batch_of(contacts.data(), creepages.data());
    if (contacts.size() == 1)
        from.a_stride = from.b_stride = from.normal_force_stride = from.shear_modulus_stride =
            from.poisson_ratio_stride = from.friction_stride = from.mismatch_stride = 0;
    from.law = law;
    std::uint32_t bad = 0;
    const status s = evaluate_batch(from, capacity(count), how, to, &bad);
    check(s, bad);
}
template <class Creepages> using batch_precision = decltype(std::declval<const Creepages &>().data()->longitudinal + 0);
} // namespace detail

/// Returns one result for each creepage. Pass one contact for all creepages, or as many contacts as creepages; `law`, null if friction is
/// constant, is for all. The exception has the index of the first bad input.
template <class Contacts, class Creepages, class T = detail::batch_precision<Creepages>>
std::vector<basic_result<T>> evaluate_batch(const Contacts &contacts, const Creepages &creepages,
                                            const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
{
    std::vector<basic_result<T>> to(creepages.size());
    detail::run_batch(contacts, creepages, how, law, batch_of(to.data()));
    return to;
}

/// The same with derivatives, with those of the law, and with the friction that agrees with the slip.
template <class Contacts, class Creepages, class T = detail::batch_precision<Creepages>>
std::vector<basic_evaluation<T>> evaluate_batch_with_derivatives(const Contacts &contacts, const Creepages &creepages,
                                                                 const options &how = {},
                                                                 const detail::only<basic_friction<T>> *law = nullptr)
{
    std::vector<basic_evaluation<T>> to(creepages.size());
    if (to.empty())
        return to;
    constexpr std::ptrdiff_t e = sizeof(basic_evaluation<T>);
    basic_evaluation<T> &first = to.front();
    basic_result<T> &r = first.result;
    detail::run_batch(contacts, creepages, how, law,
                      basic_batch_outputs<T>{&r.fx, e, &r.fy, e, &r.mz, e, &r.power, e, &r.adhesion, e, &r.status_detail,
                                             e, &first.friction, e, &first.derivatives, e, &first.law_derivatives, e});
    return to;
}

/// The form of prepare() that throws.
template <class T>
basic_prepared<T> prepare(const basic_contact<T> &ellipse, const options &how = {})
KSTRIP_HPP_THROWING(basic_prepared<T>, prepare, ellipse, how, to)

/// The form of solve() that throws.
template <class T>
basic_result<T> solve(const basic_prepared<T> &ready, const detail::only<basic_creepage<T>> &creep)
KSTRIP_HPP_THROWING(basic_result<T>, solve, ready, creep, to)

/// The form of solve_motion() that throws.
template <class T>
basic_motion_solution<T> solve_motion(const basic_contact<T> &ellipse, const detail::only<basic_motion<T>> &moving,
                                      const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_motion_solution<T>, solve_motion, ellipse, moving, law, how, to)

/// The form of solve_total() that throws.
template <class T>
basic_result<T> solve_total(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep)
KSTRIP_HPP_THROWING(basic_result<T>, solve_total, ellipse, creep, to)
/// The form of solve_strip() that throws.
template <class T>
basic_result<T> solve_strip(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                            std::int32_t strips = 0)
KSTRIP_HPP_THROWING(basic_result<T>, solve_strip, ellipse, creep, strips, to)
/// The form of solve_strip_1967() that throws.
template <class T>
basic_result<T> solve_strip_1967(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                                 std::int32_t strips = 0)
KSTRIP_HPP_THROWING(basic_result<T>, solve_strip_1967, ellipse, creep, strips, to)
/// The form of solve_linear() that throws.
template <class T>
basic_result<T> solve_linear(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep)
KSTRIP_HPP_THROWING(basic_result<T>, solve_linear, ellipse, creep, to)
#endif

// ---- Inside the contact: pressure, traction, slip ---------------------------------------------

/// The state of a point of the contact plane. See kstrip_point.
template <class T>
struct basic_point {
    basic_pascals<T> pressure, traction_x, traction_y;
    T slip_x, slip_y;
    basic_pascals<T> dissipation;
    kstrip::state state;
    std::int32_t reserved;
};
KSTRIP_HPP_BOTH(point)

/// The point (x[i], y[j]) is to[j * x.size() + i].
template <class T>
status field(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
             const detail::only<basic_friction<T>> *law, const options &how, detail::only<lengths<T>> x, detail::only<lengths<T>> y,
             detail::only<span<basic_point<T>>> to) noexcept
{
    if (!detail::fits(x.size()) || !detail::fits(y.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_field, &ellipse, &creep, law, &how, x.data(), detail::capacity(x.size()), y.data(),
                           detail::capacity(y.size()), to.data(), detail::capacity(to.size()));
}

// ---- Patches of any shape ---------------------------------------------------------------------

inline constexpr std::uint32_t patch_capacity = KSTRIP_PATCH_CAPACITY;

/// The undeformed distance of two bodies at points in ascending y. `centre_x` (for yaw; null: 0) and `rolling_radius` (null: the contact's own)
/// have one element for each point.
template <class T>
struct basic_profile {
    const basic_metres<T> *y = nullptr;
    const basic_metres<T> *distance = nullptr;
    const basic_metres<T> *centre_x = nullptr;
    const basic_metres<T> *rolling_radius = nullptr;
    std::uint32_t points = 0;
    std::uint32_t reserved = 0;
};
KSTRIP_HPP_BOTH(profile)

/// Load or approach, material and friction of two profiles that are pressed together.
template <class T>
struct basic_profile_contact {
    basic_metres<T> rolling_radius{};
    basic_newtons<T> normal_force{};
    basic_metres<T> approach{}; ///< only where normal_force is 0
    basic_metres<T> smoothing_length{};
    basic_pascals<T> shear_modulus{};
    T poisson_ratio{};
    T friction{};
    std::int32_t strips = 0;
    std::int32_t reserved = 0;
};
KSTRIP_HPP_BOTH(profile_contact)

/// One strip of a patch, along the rolling direction. See kstrip_patch_strip.
template <class T>
struct basic_patch_strip {
    basic_metres<T> y, width, half_length, centre_x;
    basic_pascals<T> peak_pressure;
    T friction;
};
KSTRIP_HPP_BOTH(patch_strip)

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
    T mismatch; ///< of the two materials; 0: like ones
};
KSTRIP_HPP_BOTH(patch)

/// Approach, load and pressure of two profiles in contact. See kstrip_profile_result.
template <class T>
struct basic_profile_result {
    basic_metres<T> approach;
    basic_newtons<T> normal_force;
    basic_newtons_per_metre<T> stiffness; ///< dN/d(approach)
    basic_pascals<T> peak_pressure;
    basic_metres<T> peak_y;
    std::uint32_t iterations;
    kstrip::status status_detail;
    basic_metres<T> lowest; ///< of the smoothed profile's distances
};
KSTRIP_HPP_BOTH(profile_result)

/// Load, friction bound and area of a patch. See kstrip_patch_summary.
template <class T>
struct basic_patch_summary {
    basic_newtons<T> normal_force, friction_bound;
    basic_square_metres<T> area;
    std::uint32_t lobes;
    std::uint32_t reserved;
};
KSTRIP_HPP_BOTH(patch_summary)

/// Calls kstrip_patch_from_profile().
template <class T>
status patch_from_profile(const basic_profile<T> &line, const basic_profile_contact<T> &load, basic_patch<T> &to,
                          detail::only<basic_profile_result<T>> *met = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_patch_from_profile, &line, &load, &to, met);
}

/// Returns error_capacity if the arrays have different sizes.
template <class T>
status patch_from_profile(detail::only<lengths<T>> y, detail::only<lengths<T>> distance,
                          const basic_profile_contact<T> &load, basic_patch<T> &to, detail::only<basic_profile_result<T>> *met = nullptr) noexcept
{
    if (y.size() != distance.size() || !detail::fits(y.size()))
        return status::error_capacity;
    // (the layouts are the same: the profile of C has plain numbers)
    using line_of_c = typename detail::twin<basic_profile<T>>::type;
    const line_of_c line{y.data(), distance.data(), nullptr, nullptr, detail::capacity(y.size()), 0};
    return KSTRIP_HPP_CALL(kstrip_patch_from_profile, &line, &load, &to, met);
}

/// Calls kstrip_patch_from_strips().
template <class T>
status patch_from_strips(detail::only<span<const basic_patch_strip<T>>> from, basic_pascals<T> shear_modulus,
                         detail::only<T> poisson_ratio, basic_patch<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_patch_from_strips, from.data(), detail::capacity(from.size()), shear_modulus,
                           poisson_ratio, &to);
}

/// Calls kstrip_patch_from_contact().
template <class T>
status patch_from_contact(const basic_contact<T> &ellipse, const options &how, basic_patch<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_patch_from_contact, &ellipse, &how, &to);
}

/// Calls kstrip_patch_summarize().
template <class T>
status summarize(const basic_patch<T> &area, basic_patch_summary<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_patch_summarize, &area, &to);
}

/// `law`: null if friction is constant.
template <class T>
status evaluate(const basic_patch<T> &area, const detail::only<basic_creepage<T>> &creep,
                const detail::only<basic_friction<T>> *law, const options &how,
                const detail::only<basic_outputs<T>> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_patch_evaluate, &area, &creep, law, &how, &to);
}

/// Calls kstrip_patch_evaluate_strips(): `own` has one creepage for each strip of the patch, or is empty.
template <class T>
status evaluate_strips(const basic_patch<T> &area, const detail::only<basic_creepage<T>> &creep,
                       detail::only<span<const basic_creepage<T>>> own, const detail::only<basic_friction<T>> *law,
                       const options &how, const detail::only<basic_outputs<T>> &to) noexcept
{
    if (own.size() != 0 && own.size() != area.count)
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_patch_evaluate_strips, &area, &creep, own.size() != 0 ? own.data() : nullptr, law, &how, &to);
}

/// The point (x[i], y[j]) is to[j * x.size() + i].
template <class T>
status field(const basic_patch<T> &area, const detail::only<basic_creepage<T>> &creep,
             const detail::only<basic_friction<T>> *law, const options &how, detail::only<lengths<T>> x, detail::only<lengths<T>> y,
             detail::only<span<basic_point<T>>> to) noexcept
{
    if (!detail::fits(x.size()) || !detail::fits(y.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_patch_field, &area, &creep, law, &how, x.data(), detail::capacity(x.size()), y.data(),
                           detail::capacity(y.size()), to.data(), detail::capacity(to.size()));
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// Result of patch_from_profile().
template <class T>
struct basic_profile_patch {
    basic_patch<T> patch;
    basic_profile_result<T> met;
};
/// The form of patch_from_profile() that throws.
template <class T>
basic_profile_patch<T> patch_from_profile(const basic_profile<T> &line, const basic_profile_contact<T> &load)
KSTRIP_HPP_THROWING(basic_profile_patch<T>, patch_from_profile, line, load, to.patch, &to.met)

/// The form of patch_from_profile() that throws.
template <class T>
basic_profile_patch<T> patch_from_profile(detail::only<lengths<T>> y, detail::only<lengths<T>> distance,
                                          const basic_profile_contact<T> &load)
KSTRIP_HPP_THROWING(basic_profile_patch<T>, patch_from_profile, y, distance, load, to.patch, &to.met)

/// The form of patch_from_strips() that throws.
template <class T>
basic_patch<T> patch_from_strips(detail::only<span<const basic_patch_strip<T>>> from, basic_pascals<T> shear_modulus,
                                 detail::only<T> poisson_ratio)
KSTRIP_HPP_THROWING(basic_patch<T>, patch_from_strips, from, shear_modulus, poisson_ratio, to)

/// The form of patch_from_contact() that throws.
template <class T>
basic_patch<T> patch_from_contact(const basic_contact<T> &ellipse, const options &how = {})
KSTRIP_HPP_THROWING(basic_patch<T>, patch_from_contact, ellipse, how, to)

/// The form of summarize() that throws.
template <class T>
basic_patch_summary<T> summarize(const basic_patch<T> &area)
KSTRIP_HPP_THROWING(basic_patch_summary<T>, summarize, area, to)

/// The form of evaluate() that throws.
template <class T>
basic_evaluation<T> evaluate(const basic_patch<T> &area, const detail::only<basic_creepage<T>> &creep,
                             const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_evaluation<T>, evaluate, area, creep, law, how, to)

/// The form of evaluate_strips() that throws.
template <class T>
basic_evaluation<T> evaluate_strips(const basic_patch<T> &area, const detail::only<basic_creepage<T>> &creep,
                                    detail::only<span<const basic_creepage<T>>> own, const options &how = {},
                                    const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_evaluation<T>, evaluate_strips, area, creep, own, law, how, to)

/// The forces of each strip of a contact or a patch. `law`: null if friction is constant.
template <template <class> class Area, class T>
std::vector<basic_strip<T>> strips(const Area<T> &area, const detail::only<basic_creepage<T>> &creep,
                                   const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
{
    std::vector<basic_strip<T>> to(strips_capacity);
    std::uint32_t count = 0;
    basic_outputs<T> request;
    request.strips = to.data(), request.count = &count, request.capacity = strips_capacity;
    detail::check(evaluate(area, creep, law, how, request));
    to.resize(count);
    return to;
}

/// Of a contact or a patch: the point (x[i], y[j]) is [j * x.size() + i].
template <template <class> class Area, class T>
std::vector<basic_point<T>> field(const Area<T> &area, const detail::only<basic_creepage<T>> &creep, const options &how,
                                  detail::only<lengths<T>> x,
                                  detail::only<lengths<T>> y, const detail::only<basic_friction<T>> *law = nullptr)
{
    std::vector<basic_point<T>> to(x.size() * y.size());
    detail::check(field(area, creep, law, how, x, y, to));
    return to;
}
#endif

// ---- Wheel on rail ----------------------------------------------------------------------------

inline constexpr std::uint32_t surface_capacity = KSTRIP_SURFACE_CAPACITY;
inline constexpr std::uint32_t contacts_capacity = KSTRIP_CONTACTS_CAPACITY;
inline constexpr std::uint32_t rail_friction_capacity = KSTRIP_RAIL_FRICTION_CAPACITY;

/// A profile, prepared: 16 KiB, 8 in single precision.
template <class T>
struct basic_surface {
    basic_metres<T> y[surface_capacity], z[surface_capacity];
    T cosine[surface_capacity], sine[surface_capacity];
    basic_metres<T> step, spacing;
    std::uint32_t count;
    std::uint32_t form;
};
KSTRIP_HPP_BOTH(surface)

/// Position of the wheel on straight track. See kstrip_wheel_position.
template <class T>
struct basic_wheel_position {
    basic_metres<T> lateral{}, vertical{}; ///< y of the wheel's centre; its depth below one wheel radius above the rail
    basic_radians<T> yaw{}, roll{};
};
KSTRIP_HPP_BOTH(wheel_position)

/// Velocity of the wheel relative to the rail. See kstrip_wheel_velocity.
template <class T>
struct basic_wheel_velocity {
    basic_metres_per_second<T> forward{}, lateral{}, vertical{};
    basic_radians_per_second<T> roll{}, pitch{}, yaw{}; ///< about the wheelset's own axes; pitch is about -forward/radius
    /// In the order of the derivatives of a wrench
    constexpr operator std::array<T, 6>() const noexcept
    {
        return {forward.value, lateral.value, vertical.value, roll.value, pitch.value, yaw.value};
    }
};
KSTRIP_HPP_BOTH(wheel_velocity)

/// The position of six numbers in the order of the derivatives of a wrench: forward, lateral, vertical [m], roll, pitch, yaw [rad].
/// Forward and pitch have no influence.
template <class T>
constexpr basic_wheel_position<T> wheel_position_of(const std::array<T, 6> &six) noexcept
{
    return {basic_metres<T>(six[1]), basic_metres<T>(six[2]), basic_radians<T>(six[5]), basic_radians<T>(six[3])};
}

/// The velocity of six numbers in the same order [m/s, rad/s].
template <class T>
constexpr basic_wheel_velocity<T> wheel_velocity_of(const std::array<T, 6> &six) noexcept
{
    return {basic_metres_per_second<T>(six[0]),   basic_metres_per_second<T>(six[1]),   basic_metres_per_second<T>(six[2]),
            basic_radians_per_second<T>(six[3]), basic_radians_per_second<T>(six[4]), basic_radians_per_second<T>(six[5])};
}

/// A finished contact table, from which a function takes the contacts of wheels. See kstrip_table.
struct table {
    const std::uint8_t *data = nullptr;
    std::uint32_t bytes = 0;
    std::int32_t only = 0; ///< not 0: a position outside the table is an error; 0: its contacts are computed
};
KSTRIP_HPP_SAME(table, kstrip_table)

/// Materials, friction (one number, or numbers at places y of the rail), side, strips, model.
template <class T>
struct basic_wheel_pair {
    basic_metres<T> wheel_radius{};
    basic_pascals<T> shear_modulus{};
    T poisson_ratio{};
    T friction{};
    basic_metres<T> friction_y[rail_friction_capacity]{};
    T friction_at[rail_friction_capacity]{};
    std::uint32_t friction_points = 0;
    std::int32_t left = 0;
    basic_metres<T> smoothing_length{};
    std::int32_t strips = 0;
    kstrip::model model = kstrip::model::default_;
    T normal_damping{};
    basic_metres_per_second<T> floor_speed{};
    basic_metres<T> rail_radius{}; ///< of a roller; 0: a straight rail
    basic_metres<T> rail_ahead{};
    basic_metres_per_second<T> rail_speed{};
};
KSTRIP_HPP_BOTH(wheel_pair)

/// The gap between the surfaces along the rail; the first `count` elements are used.
template <class T>
struct basic_gap {
    basic_metres<T> along[surface_capacity], distance[surface_capacity];
    basic_metres<T> x[surface_capacity], y[surface_capacity], z[surface_capacity];
    basic_radians<T> angle[surface_capacity];
    basic_metres<T> rolling_radius[surface_capacity];
    basic_metres<T> step; ///< of the wheel's points; 0: the mean distance of these points
    std::uint32_t count;
    std::uint32_t reserved;
};
KSTRIP_HPP_BOTH(gap)

/// One contact of a wheel. See kstrip_wheel_contact.
template <class T>
struct basic_wheel_contact {
    basic_metres<T> origin[3];
    basic_radians<T> angle, angle_range;
    basic_metres<T> radius;
    basic_newtons<T> normal_force;
    T share;
    basic_metres<T> approach;
    basic_newtons_per_metre<T> stiffness;
    basic_metres<T> along;
    T normal[6], slip_x[6], slip_y[6], spin_rate[6], rolling_speed[6]; ///< derivatives with respect to the members of the velocity
    T normal_damping;
    basic_motion<T> at_rest; ///< of the rail's surface
    basic_patch<T> patch;
    basic_metres<T> rail_axis[2];
    basic_radians_per_second<T> rail_rate;
    basic_metres_per_second<T> strip_rail_speed[patch_capacity];
    basic_metres<T> strip_y[patch_capacity], strip_z[patch_capacity];
    basic_radians<T> strip_angle[patch_capacity];
    T strip_lean[patch_capacity];
    basic_radians<T> turned[2];
    std::int32_t left;
    std::int32_t reserved;
};
KSTRIP_HPP_BOTH(wheel_contact)

/// One strip of a contact of a wheel, and the power that friction dissipates in it. See kstrip_strip_power.
template <class T>
struct basic_strip_power {
    basic_metres<T> wheel_y, width;
    basic_newtons<T> normal_force, fx, fy;
    basic_metres_per_second<T> slip;
    T power; ///< W
};
KSTRIP_HPP_BOTH(strip_power)

/// Memory for one wheel. After a call it holds the gap and the contacts.
template <class T>
struct basic_wheel_workspace {
    basic_gap<T> gap;
    basic_patch<T> strips;
    basic_wheel_contact<T> contacts[contacts_capacity];
    std::uint32_t count;
    std::uint32_t reserved;
};
KSTRIP_HPP_BOTH(wheel_workspace)

/// Force (track) and moment (wheelset's own axes) on the wheel at its centre.
template <class T>
struct basic_wrench {
    basic_newtons<T> force[3];
    basic_newton_metres<T> moment[3];
    T dissipation; ///< W
    basic_newtons<T> normal_force;
    std::uint32_t contacts;
    status status_detail;
    /// Force along x, y, z [N], moment about x, y, z [N m]
    constexpr operator std::array<T, 6>() const noexcept
    {
        return {force[0].value, force[1].value, force[2].value, moment[0].value, moment[1].value, moment[2].value};
    }
};
KSTRIP_HPP_BOTH(wrench)

/// Exact derivatives of the wrench. See kstrip_wrench_derivatives.
template <class T>
struct basic_wrench_derivatives {
    T velocity[6][6];
    T friction[6];
};
KSTRIP_HPP_BOTH(wrench_derivatives)

/// Derivatives of the wrench with respect to the wheel's position at constant velocity. See kstrip_wrench_by_position.
template <class T>
struct basic_wrench_by_position {
    T lateral[6], vertical[6], yaw[6], roll[6];
};
KSTRIP_HPP_BOTH(wrench_by_position)

/// Returns error_capacity if the arrays have different sizes.
template <class T>
status prepare_profile(detail::only<lengths<T>> y, detail::only<lengths<T>> z, detail::only<basic_metres<T>> step,
                       detail::only<basic_metres<T>> smoothing_length, basic_surface<T> &to) noexcept
{
    if (y.size() != z.size() || !detail::fits(y.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_prepare_profile, y.data(), z.data(), detail::capacity(y.size()), step,
                           smoothing_length, &to);
}

/// `format` is a constant KSTRIP_FORMAT_; `notes` is a sum of KSTRIP_NOTE_.
template <class T>
status read_profile(std::string_view text, std::uint32_t format, T *y, T *z, std::uint32_t room, std::uint32_t &count,
                    std::uint32_t &notes) noexcept
{
    if (!detail::fits(text.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_read_profile, text.data(), detail::capacity(text.size()), format, y, z, room, &count, &notes);
}

/// The profiles of `counts` points stand one after the other in `y` and `z`. A `unit` of 0 is found. `format` is a sum of constants
/// KSTRIP_FORMAT_; `notes` is a sum of KSTRIP_NOTE_.
template <class T>
status orient_profiles(const T *y, const T *z, const std::uint32_t *counts, std::uint32_t profile_count, std::uint32_t format,
                       detail::only<T> unit, T *turned_y, T *turned_z, T &taken_unit, std::uint32_t &notes) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_orient_profiles, y, z, counts, profile_count, format, unit, turned_y, turned_z, &taken_unit, &notes);
}

/// Calls kstrip_profile_between().
template <class T>
status profile_between(const basic_surface<T> &first, const basic_surface<T> &second, detail::only<T> share, basic_surface<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_profile_between, &first, &second, share, &to);
}

/// A `reach` of 0 means 2 mm. Pass null if `least`, the smallest distance, is not needed.
template <class T>
status touch(const basic_surface<T> &rail, const basic_surface<T> &wheel, basic_metres<T> wheel_radius,
             const basic_wheel_position<T> &where, detail::only<basic_metres<T>> reach, basic_gap<T> &to,
             detail::only<basic_metres<T>> *least = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_touch, &rail, &wheel, wheel_radius, &where, reach, &to, least);
}

/// Calls kstrip_contacts_from_gap().
template <class T>
status contacts_from_gap(const basic_gap<T> &between, const basic_wheel_pair<T> &both,
                         const basic_wheel_position<T> &where, basic_patch<T> &workspace,
                         basic_wheel_contact<T> (&to)[contacts_capacity], std::uint32_t &count) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_contacts_from_gap, &between, &both, &where, &workspace, &to[0], &count);
}

/// Calls kstrip_wheel_motion().
template <class T>
status wheel_motion(const basic_wheel_contact<T> &at, const basic_wheel_velocity<T> &moves,
                    basic_motion<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wheel_motion, &at, &moves, &to);
}

/// `law`: null if friction is constant; `count` receives the number of strips.
template <class T>
status contact_power_across(const basic_wheel_contact<T> &at, const basic_wheel_velocity<T> &moves, model how,
                            const detail::only<basic_friction<T>> *law,
                            detail::only<span<basic_strip_power<T>>> to, std::uint32_t &count) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_contact_power_across, &at, &moves, static_cast<std::int32_t>(how), law, to.data(),
                           detail::capacity(to.size()), &count);
}

/// `law`: null if friction is constant; `slopes`: null if they are not needed.
template <class T>
status wrench_from_contacts(detail::only<span<const basic_wheel_contact<T>>> contacts,
                            const basic_wheel_velocity<T> &moves, model how,
                            const detail::only<basic_friction<T>> *law, basic_wrench<T> &to,
                            detail::only<basic_wrench_derivatives<T>> *slopes = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wrench_from_contacts, contacts.data(), detail::capacity(contacts.size()), &moves,
                           static_cast<std::int32_t>(how), law, &to, slopes);
}

/// `law`: null if friction is constant; `slopes`, `by_position`: null if they are not needed.
template <class T>
status wheel_on_rail(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both,
                     const basic_wheel_position<T> &where, const basic_wheel_velocity<T> &moves,
                     const detail::only<basic_friction<T>> *law, basic_wheel_workspace<T> &workspace,
                     basic_wrench<T> &to, detail::only<basic_wrench_derivatives<T>> *slopes = nullptr,
                     detail::only<basic_wrench_by_position<T>> *by_position = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wheel_on_rail, &rail, &wheel, &both, &where, &moves, law, &workspace, &to, slopes,
                           by_position);
}

/// Ranges of a contact table, and how many nodes it has; zero: the library's choice. See kstrip_table_spec.
template <class T>
struct basic_table_spec {
    basic_metres<T> lateral_from{}, lateral_to{};
    basic_radians<T> yaw{}, roll{};
    basic_newtons<T> load{};
    std::uint32_t lateral_nodes{}, levels{}, yaw_nodes{}, roll_nodes{}, strips{}, reserved{};
};
KSTRIP_HPP_BOTH(table_spec)

/// The length of a contact table, and its measured error. See kstrip_table_report.
template <class T>
struct basic_table_report {
    T force_usual, force_largest, load_usual, load_largest;
    std::uint32_t bytes, poses, missing, empty;
};
KSTRIP_HPP_BOTH(table_report)

/// The memory that a table needs while it is filled, and the number of its parts.
template <class T>
status table_size(const basic_surface<T> &wheel, const basic_table_spec<T> &spec, std::uint32_t &bytes, std::uint32_t &parts) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_table_size, &wheel, &spec, &bytes, &parts);
}

template <class T>
status table_begin(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both,
                   const basic_table_spec<T> &spec, basic_wheel_workspace<T> &workspace, std::uint8_t *table, std::uint32_t bytes) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_table_begin, &rail, &wheel, &both, &spec, &workspace, table, bytes);
}

/// Several threads may each fill other parts, with a separate workspace.
template <class T>
status table_fill(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both, std::uint32_t first,
                  std::uint32_t count, basic_wheel_workspace<T> &workspace, std::uint8_t *table, std::uint32_t bytes) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_table_fill, &rail, &wheel, &both, first, count, &workspace, table, bytes);
}

template <class T>
status table_finish(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both, std::uint32_t poses,
                    basic_wheel_workspace<T> &workspace, std::uint8_t *table, std::uint32_t bytes, basic_table_report<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_table_finish, &rail, &wheel, &both, poses, &workspace, table, bytes, &to);
}

/// Reads all of a table that comes from a file.
inline status table_check(const std::uint8_t *table, std::uint32_t bytes, std::uint32_t &length) noexcept
{
    return static_cast<status>(kstrip_table_check(table, bytes, &length));
}

/// `law`: null if friction is constant; `workspace`: null if the contacts are not needed; `slopes`, `by_position`: null if they are
/// not needed.
template <class T>
status wheel_on_table(const table &from, const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where,
                      const basic_wheel_velocity<T> &moves, const detail::only<basic_friction<T>> *law,
                      detail::only<basic_wheel_workspace<T>> *workspace, basic_wrench<T> &to,
                      detail::only<basic_wrench_derivatives<T>> *slopes = nullptr,
                      detail::only<basic_wrench_by_position<T>> *by_position = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wheel_on_table, &from, &both, &where, &moves, law, workspace, &to, slopes, by_position);
}

namespace detail {
/// From one element of an array to the next: 0 if one element is used for all.
template <class T>
std::uint32_t spacing(span<T> array) noexcept
{
    return array.size() == 1 ? 0 : static_cast<std::uint32_t>(sizeof(T));
}
/// Whether arrays have one element for all, or as many as there are results.
template <class... Arrays>
bool fit(std::size_t count, const Arrays &...arrays) noexcept
{
    return fits(count) && ((arrays.size() == 1 || arrays.size() == count) && ...);
}
/// Whether there are no statuses, or as many as there are results.
inline bool are_for(span<std::int32_t> statuses, std::size_t count) noexcept
{
    return statuses.size() == 0 || statuses.size() == count;
}
/// The largest of several sizes.
template <class... Arrays>
std::size_t largest(const Arrays &...arrays) noexcept
{
    std::size_t found = 0;
    ((found = found < arrays.size() ? arrays.size() : found), ...);
    return found;
}
} // namespace detail

/// Many wheels: `both`, `where` and `moves` have one element for all, or one for each of `to` and `statuses`.
/// `contacts`: the same number of elements for each wheel, for its first contacts; empty: not needed.
/// `from`: a contact table of all pairs; null: contacts are computed.
template <class T>
status wheels_on_rails(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                       detail::only<span<const basic_wheel_pair<T>>> both,
                       detail::only<span<const basic_wheel_position<T>>> where,
                       detail::only<span<const basic_wheel_velocity<T>>> moves,
                       const detail::only<basic_friction<T>> *law, basic_wheel_workspace<T> &workspace,
                       detail::only<span<basic_wrench<T>>> to, span<std::int32_t> statuses,
                       detail::only<basic_wrench_derivatives<T>> *slopes = nullptr,
                       detail::only<basic_wrench_by_position<T>> *by_position = nullptr,
                       detail::only<span<basic_wheel_contact<T>>> contacts = {}, const table *from = nullptr) noexcept
{
    const std::size_t count = to.size(), room = count ? contacts.size() / count : 0;
    if (!detail::fit(count, both, where, moves) || statuses.size() != count || contacts.size() != room * count)
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_wheels_on_rails, &rail, &wheel, detail::capacity(count), both.data(),
                           detail::spacing(both), where.data(), detail::spacing(where), moves.data(),
                           detail::spacing(moves), law, std::uint32_t{0}, from, &workspace, to.data(), slopes, by_position,
                           room ? contacts.data() : nullptr, detail::capacity(room), statuses.data());
}

/// `moves`: the velocity of the wheel; null: the pressure carries the whole load. `from`: a contact table; null: contacts are computed.
template <class T>
status height_for_load(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both,
                       const basic_wheel_position<T> &where, detail::only<basic_newtons<T>> support,
                       const detail::only<basic_wheel_velocity<T>> *moves,
                       const detail::only<basic_friction<T>> *law, basic_wheel_workspace<T> &workspace,
                       basic_metres<T> &to, const table *from = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_height_for_load, &rail, &wheel, &both, &where, support, moves, law, from, &workspace,
                           &to);
}

/// Many heights: arrays have one element for all, or one for each of `to` and `statuses`. `moves`: empty: the pressure carries
/// the whole load. `from`: a contact table of all pairs; null: contacts are computed.
template <class T>
status heights_for_loads(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                         detail::only<span<const basic_wheel_pair<T>>> both,
                         detail::only<span<const basic_wheel_position<T>>> where,
                         detail::only<span<const basic_newtons<T>>> supports,
                         detail::only<span<const basic_wheel_velocity<T>>> moves,
                         const detail::only<basic_friction<T>> *law, basic_wheel_workspace<T> &workspace,
                         detail::only<span<basic_metres<T>>> to, span<std::int32_t> statuses, const table *from = nullptr) noexcept
{
    const std::size_t count = to.size();
    const bool moving = moves.size() != 0;
    if (!detail::fit(count, both, where, supports) || (moving && !detail::fit(count, moves)) || statuses.size() != count)
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_heights_for_loads, &rail, &wheel, detail::capacity(count), both.data(),
                           detail::spacing(both), where.data(), detail::spacing(where), supports.data(),
                           detail::spacing(supports), moving ? moves.data() : nullptr, detail::spacing(moves), law,
                           std::uint32_t{0}, from, &workspace, to.data(), statuses.data());
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// `y`, `z`: arrays, vectors or spans of plain numbers in metres, or of kstrip::metres. A `step` or `smoothing_length` of 0 is the default.
template <class Lengths, class T = detail::precision_of<const Lengths>>
basic_surface<T> prepare_profile(const Lengths &y, const Lengths &z, detail::only<basic_metres<T>> step = {},
                                 detail::only<basic_metres<T>> smoothing_length = {})
KSTRIP_HPP_THROWING(basic_surface<T>, (prepare_profile<T>), y, z, step, smoothing_length, to)

/// The points of a profile file, for prepare_profile().
template <class T>
struct basic_profile_points {
    std::vector<basic_metres<T>> y;
    std::vector<basic_metres<T>> z;
    std::uint32_t notes; ///< findings and changes, a sum of KSTRIP_NOTE_
};
/// Reads a file. Its extension determines the kind if `format` does not. Throws std::system_error for a file that cannot be opened.
template <class T = double>
basic_profile_points<T> read_profile(const std::string &path, std::uint32_t format = KSTRIP_FORMAT_ANY)
{
    const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw std::system_error(errno, std::generic_category(), path);
    std::string text;
    char part[4096];
    for (std::size_t read = 0; (read = std::fread(part, 1, sizeof part, file.get())) > 0;)
        text.append(part, read);
    if (std::ferror(file.get()))
        throw std::system_error(errno, std::generic_category(), path);
    const auto ends = [&path](std::string_view end) {
        return path.size() >= end.size() && std::equal(end.begin(), end.end(), path.end() - static_cast<std::ptrdiff_t>(end.size()),
                                                       [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b - 'A' + 'a' : b); });
    };
    if (format < KSTRIP_FORMAT_WHEEL && (ends(".prw") || ends(".whl") || ends(".wheel")))
        format += KSTRIP_FORMAT_WHEEL;
    if (format < KSTRIP_FORMAT_WHEEL && (ends(".prr") || ends(".ban") || ends(".rail")))
        format += KSTRIP_FORMAT_RAIL;
    // A point has at least four characters.
    std::vector<T> y(text.size() / 4 + 8), z(y.size());
    std::uint32_t count = 0;
    basic_profile_points<T> to{};
    detail::check(read_profile(text, format, y.data(), z.data(), detail::capacity(y.size()), count, to.notes));
    for (std::uint32_t i = 0; i < count; i++)
        to.y.emplace_back(y[i]), to.z.emplace_back(z[i]);
    return to;
}

/// The points of one profile the right way round, from arrays in metres in their order along the profile.
template <class Lengths, class T = detail::precision_of<const Lengths>>
basic_profile_points<T> orient_profiles(const Lengths &y, const Lengths &z, std::uint32_t format = KSTRIP_FORMAT_ANY)
{
    const lengths<T> across(y), down(z);
    if (across.size() != down.size() || !detail::fits(across.size()))
        detail::check(status::error_capacity);
    const std::uint32_t count = detail::capacity(across.size());
    std::vector<T> turned_y(count), turned_z(count);
    T unit = 1;
    basic_profile_points<T> to{};
    detail::check(orient_profiles(across.data(), down.data(), &count, 1, format, unit, turned_y.data(), turned_z.data(), unit, to.notes));
    for (std::uint32_t i = 0; i < count; i++)
        to.y.emplace_back(turned_y[i]), to.z.emplace_back(turned_z[i]);
    return to;
}

/// The form of profile_between() that throws.
template <class T>
basic_surface<T> profile_between(const basic_surface<T> &first, const basic_surface<T> &second, detail::only<T> share)
KSTRIP_HPP_THROWING(basic_surface<T>, profile_between, first, second, share, to)

/// Result of touch().
template <class T>
struct basic_touch {
    basic_gap<T> gap;
    basic_metres<T> least; ///< smallest distance; negative where the surfaces overlap
};
/// A `reach` of 0 means 2 mm.
template <class T>
basic_touch<T> touch(const basic_surface<T> &rail, const basic_surface<T> &wheel, detail::only<basic_metres<T>> wheel_radius,
                     const basic_wheel_position<T> &where, detail::only<basic_metres<T>> reach = {})
KSTRIP_HPP_THROWING(basic_touch<T>, touch, rail, wheel, wheel_radius, where, reach, to.gap, &to.least)

/// The contacts, in ascending y of a right wheel.
template <class T>
std::vector<basic_wheel_contact<T>> contacts_from_gap(const basic_gap<T> &between, const basic_wheel_pair<T> &both,
                                                      const basic_wheel_position<T> &where)
{
    struct memory {
        basic_patch<T> workspace;
        basic_wheel_contact<T> contacts[contacts_capacity];
    };
    std::vector<memory> one(1);
    memory &room = one.front();
    std::uint32_t count = 0;
    detail::check(contacts_from_gap(between, both, where, room.workspace, room.contacts, count));
    return {&room.contacts[0], &room.contacts[0] + count};
}

/// The form of wheel_motion() that throws.
template <class T>
basic_motion<T> wheel_motion(const basic_wheel_contact<T> &at, const basic_wheel_velocity<T> &moves)
KSTRIP_HPP_THROWING(basic_motion<T>, wheel_motion, at, moves, to)

/// Load, sliding velocity and frictional power of each strip of a contact. `law`: null if friction is constant.
template <class T>
std::vector<basic_strip_power<T>> contact_power_across(const basic_wheel_contact<T> &at, const basic_wheel_velocity<T> &moves,
                                                       model how = model::default_,
                                                       const detail::only<basic_friction<T>> *law = nullptr)
{
    std::vector<basic_strip_power<T>> to(patch_capacity);
    std::uint32_t count = 0;
    detail::check(contact_power_across<T>(at, moves, how, law, to, count));
    to.resize(count);
    return to;
}

/// Force and moment on a wheel with their derivatives.
template <class T>
struct basic_wheel_forces {
    basic_wrench<T> wrench;
    basic_wrench_derivatives<T> derivatives; ///< with respect to velocity and friction
};
/// `law`: null if friction is constant.
template <class T>
basic_wheel_forces<T> wrench_from_contacts(detail::only<span<const basic_wheel_contact<T>>> contacts,
                                           const basic_wheel_velocity<T> &moves, model how = model::default_,
                                           const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_wheel_forces<T>, wrench_from_contacts, contacts, moves, how, law, to.wrench, &to.derivatives)

/// The wrench alone. `law`: null if friction is constant.
template <class T>
basic_wrench<T> wheel_on_rail(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                              const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where,
                              const basic_wheel_velocity<T> &moves, basic_wheel_workspace<T> &workspace,
                              const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_wrench<T>, wheel_on_rail, rail, wheel, both, where, moves, law, workspace, to)

/// The wrenches of many wheels, with their numbers of contacts. `both`, `where`, `moves`: one element for all, or one for each.
template <class T>
results<basic_wrench<T>> wheels_on_rails(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                                         detail::only<span<const basic_wheel_pair<T>>> both,
                                         detail::only<span<const basic_wheel_position<T>>> where,
                                         detail::only<span<const basic_wheel_velocity<T>>> moves,
                                         basic_wheel_workspace<T> &workspace,
                                         const detail::only<basic_friction<T>> *law = nullptr, const table *from = nullptr)
{
    const std::size_t count = detail::largest(both, where, moves);
    results<basic_wrench<T>> found(count);
    found.statuses = detail::each_status(count, [&](span<std::int32_t> statuses) {
        return wheels_on_rails<T>(rail, wheel, both, where, moves, law, workspace,
                                  span<basic_wrench<T>>(found.data(), count), statuses, nullptr, nullptr, {}, from);
    });
    return found;
}

/// The wrench with its derivatives.
template <class T>
struct basic_wheel_evaluation {
    basic_wrench<T> wrench;
    basic_wrench_derivatives<T> derivatives; ///< with respect to velocity and friction
    basic_wrench_by_position<T> by_position; ///< zero unless they are requested
};
/// `law`: null if friction is constant. `by_position`: whether to compute the derivatives with respect to the position too.
template <class T>
basic_wheel_evaluation<T> wheel_on_rail_with_derivatives(
    const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both,
    const basic_wheel_position<T> &where, const basic_wheel_velocity<T> &moves, basic_wheel_workspace<T> &workspace,
    const detail::only<basic_friction<T>> *law = nullptr, bool by_position = false)
KSTRIP_HPP_THROWING(basic_wheel_evaluation<T>, wheel_on_rail, rail, wheel, both, where, moves, law, workspace, to.wrench,
                    &to.derivatives, by_position ? &to.by_position : nullptr)

/// `moves`: the velocity of the wheel; null: the pressure carries the whole load.
template <class T>
basic_metres<T> height_for_load(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                                const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where,
                                detail::only<basic_newtons<T>> support, basic_wheel_workspace<T> &workspace,
                                const detail::only<basic_wheel_velocity<T>> *moves = nullptr,
                                const detail::only<basic_friction<T>> *law = nullptr, const table *from = nullptr)
KSTRIP_HPP_THROWING(basic_metres<T>, height_for_load, rail, wheel, both, where, support, moves, law, workspace, to, from)

/// A contact table that owns its memory: filled, or read from the bytes of a file.
template <class T>
class basic_contact_table {
  public:
    /// Filled in this thread. `poses`: at how many positions the error is measured.
    basic_contact_table(const basic_surface<T> &rail, const basic_surface<T> &wheel, const basic_wheel_pair<T> &both,
                        const basic_table_spec<T> &spec, basic_wheel_workspace<T> &workspace, std::uint32_t poses = 500)
    {
        std::uint32_t size = 0, parts = 0;
        detail::check(table_size(wheel, spec, size, parts));
        own.resize(size);
        detail::check(table_begin(rail, wheel, both, spec, workspace, own.data(), size));
        detail::check(table_fill(rail, wheel, both, 0, parts, workspace, own.data(), size));
        basic_table_report<T> found{};
        detail::check(table_finish(rail, wheel, both, poses, workspace, own.data(), size, found));
        own.resize(found.bytes);
        own.shrink_to_fit();
        measured = found;
    }
    /// Read from bytes, which are checked. The report is zero.
    explicit basic_contact_table(std::vector<std::uint8_t> bytes) : own(std::move(bytes))
    {
        std::uint32_t length = 0;
        detail::check(table_check(own.data(), detail::capacity(own.size()), length));
        own.resize(length);
    }
    /// The bytes, for a file.
    const std::vector<std::uint8_t> &bytes() const noexcept { return own; }
    const basic_table_report<T> &report() const noexcept { return measured; }
    /// For functions that take contacts from a table. `only`: whether a position outside the table is an error; else its contacts
    /// are computed.
    table view(bool only = false) const noexcept { return {own.data(), detail::capacity(own.size()), only ? 1 : 0}; }
    /// The wrench alone. `law`: null if friction is constant.
    basic_wrench<T> wheel(const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where, const basic_wheel_velocity<T> &moves,
                          basic_wheel_workspace<T> &workspace, const basic_friction<T> *law = nullptr) const
    {
        basic_wrench<T> to{};
        detail::check(wheel_on_table(view(), both, where, moves, law, &workspace, to));
        return to;
    }
    /// The same without the contacts.
    basic_wrench<T> wheel(const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where, const basic_wheel_velocity<T> &moves,
                          const basic_friction<T> *law = nullptr) const
    {
        basic_wrench<T> to{};
        detail::check(wheel_on_table<T>(view(), both, where, moves, law, nullptr, to));
        return to;
    }
    /// The wrench with its derivatives. `by_position`: whether to compute those with respect to the position too.
    basic_wheel_evaluation<T> wheel_with_derivatives(const basic_wheel_pair<T> &both, const basic_wheel_position<T> &where,
                                                     const basic_wheel_velocity<T> &moves, basic_wheel_workspace<T> &workspace,
                                                     const basic_friction<T> *law = nullptr, bool by_position = false) const
    {
        basic_wheel_evaluation<T> to{};
        detail::check(wheel_on_table(view(), both, where, moves, law, &workspace, to.wrench, &to.derivatives,
                                     by_position ? &to.by_position : nullptr));
        return to;
    }

  private:
    std::vector<std::uint8_t> own;
    basic_table_report<T> measured{};
};
using contact_table = basic_contact_table<double>;
using contact_table_f32 = basic_contact_table<float>;

/// The heights of many wheels. Arrays: one element for all, or one for each. `moves`: empty: the pressure carries the load.
template <class T>
results<basic_metres<T>> heights_for_loads(const basic_surface<T> &rail, const basic_surface<T> &wheel,
                                           detail::only<span<const basic_wheel_pair<T>>> both,
                                           detail::only<span<const basic_wheel_position<T>>> where,
                                           detail::only<span<const basic_newtons<T>>> supports,
                                           basic_wheel_workspace<T> &workspace,
                                           detail::only<span<const basic_wheel_velocity<T>>> moves = {},
                                           const detail::only<basic_friction<T>> *law = nullptr)
{
    const std::size_t count = detail::largest(both, where, supports, moves);
    results<basic_metres<T>> found(count);
    found.statuses = detail::each_status(count, [&](span<std::int32_t> statuses) {
        return heights_for_loads<T>(rail, wheel, both, where, supports, moves, law, workspace,
                                    span<basic_metres<T>>(found.data(), count), statuses);
    });
    return found;
}
#endif

// ---- The wheelset: two wheels on two rails -----------------------------------------------------

inline constexpr std::uint32_t wheelset_freedoms = KSTRIP_WHEELSET_FREEDOMS;

/// Displacement and velocity of a rail.
template <class T>
struct basic_rail_motion {
    basic_metres<T> lateral{}, vertical{};
    basic_metres_per_second<T> lateral_velocity{}, vertical_velocity{};
};
KSTRIP_HPP_BOTH(rail_motion)

/// Two rails: right, left. A left profile that is null is the same as the right one; origins that are 0 follow from the gauge.
template <class T>
struct basic_track {
    const basic_surface<T> *rail[2] = {};
    basic_metres<T> gauge{}, gauge_depth{};
    basic_metres<T> origin[2]{};
    basic_rail_motion<T> motion[2]{};
};
KSTRIP_HPP_BOTH(track)

/// A curve: positive curvature to the right, positive cant where the right rail is lower.
template <class T>
struct basic_curve {
    basic_metres_per_second<T> speed{};
    basic_per_metre<T> curvature{};
    basic_radians<T> cant{};
    T gravity{}; ///< m/s^2; 0: 9.80665
};
KSTRIP_HPP_BOTH(curve)

/// Two wheels: right, left. A left wheel whose profile is null, or whose radius is 0, has the values of the right one.
template <class T>
struct basic_wheelset {
    const basic_surface<T> *wheel[2] = {};
    const basic_friction<T> *friction[2] = {}; ///< null: constant
    const kstrip::table *table[2] = {};        ///< null: contacts are computed
    basic_wheel_pair<T> pair[2]{};
    basic_metres<T> back_to_back{}, running_circles{};
};
KSTRIP_HPP_BOTH(wheelset)

template <class T>
struct basic_wheelset_workspace {
    basic_wheel_workspace<T> wheel[2];
};
KSTRIP_HPP_BOTH(wheelset_workspace)

template <class T>
struct basic_wheelset_forces {
    basic_wrench<T> wrench, wheel[2];
    basic_newtons<T> rail[2][3]; ///< forward, lateral (Y), vertical (Q)
};
KSTRIP_HPP_BOTH(wheelset_forces)

template <class T>
struct basic_wheelset_derivatives {
    T velocity[wheelset_freedoms][wheelset_freedoms];
    T friction[wheelset_freedoms];
};
KSTRIP_HPP_BOTH(wheelset_derivatives)

template <class T>
struct basic_wheelset_by_position {
    T position[wheelset_freedoms][wheelset_freedoms];
};
KSTRIP_HPP_BOTH(wheelset_by_position)

/// Loads of the vehicle and of gravity on the wheelset.
template <class T>
struct basic_wheelset_loads {
    basic_newtons<T> vertical{};
    basic_newton_metres<T> roll{}, pitch{};
};
KSTRIP_HPP_BOTH(wheelset_loads)

/// A `depth` of 0 means 14 mm.
template <class T>
status gauge_face(const basic_surface<T> &rail, detail::only<basic_metres<T>> depth, basic_metres<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_gauge_face, &rail, depth, &to);
}

/// `weight`: three numbers [m/s^2]; pass null if it is not needed.
template <class T>
status curve_motion(const basic_curve<T> &through, const basic_wheel_position<T> &where,
                    const basic_wheel_velocity<T> &relative, basic_wheel_velocity<T> &to,
                    detail::only<T> *weight = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_curve_motion, &through, &where, &relative, &to, weight);
}

/// `slopes`, `by_position`: pass null if they are not needed.
template <class T>
status wheelset_on_track(const basic_wheelset<T> &set, const basic_track<T> &rails, const basic_wheel_position<T> &where,
                         const basic_wheel_velocity<T> &moves, basic_wheelset_workspace<T> &workspace,
                         basic_wheelset_forces<T> &to, detail::only<basic_wheelset_derivatives<T>> *slopes = nullptr,
                         detail::only<basic_wheelset_by_position<T>> *by_position = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wheelset_on_track, &set, &rails, &where, &moves, &workspace, &to, slopes,
                           by_position);
}

/// `to_forces`: pass null if they are not needed.
template <class T>
status wheelset_settle(const basic_wheelset<T> &set, const basic_track<T> &rails, const basic_wheel_position<T> &start,
                       const basic_wheel_velocity<T> &moves, const basic_wheelset_loads<T> &loads,
                       basic_wheelset_workspace<T> &workspace, basic_wheel_position<T> &to,
                       basic_wheel_velocity<T> &to_moves,
                       detail::only<basic_wheelset_forces<T>> *to_forces = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_wheelset_settle, &set, &rails, &start, &moves, &loads, &workspace, &to,
                           &to_moves, to_forces);
}

/// Many positions: `where` and `moves` have one element for all, or one for each of `to` and `statuses`.
/// `slopes`, `by_position`: arrays of as many elements; pass null if they are not needed.
template <class T>
status wheelsets_on_track(const basic_wheelset<T> &set, const basic_track<T> &rails,
                          detail::only<span<const basic_wheel_position<T>>> where,
                          detail::only<span<const basic_wheel_velocity<T>>> moves,
                          basic_wheelset_workspace<T> &workspace, detail::only<span<basic_wheelset_forces<T>>> to,
                          span<std::int32_t> statuses, detail::only<basic_wheelset_derivatives<T>> *slopes = nullptr,
                          detail::only<basic_wheelset_by_position<T>> *by_position = nullptr) noexcept
{
    const std::size_t count = to.size();
    if (!detail::fit(count, where, moves) || statuses.size() != count)
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_wheelsets_on_track, &set, &rails, detail::capacity(count), where.data(),
                           detail::spacing(where), moves.data(), detail::spacing(moves), &workspace, to.data(), slopes,
                           by_position, statuses.data());
}

/// Many balances: arrays have one element for all, or one for each of the results.
template <class T>
status wheelsets_settle(const basic_wheelset<T> &set, const basic_track<T> &rails,
                        detail::only<span<const basic_wheel_position<T>>> start,
                        detail::only<span<const basic_wheel_velocity<T>>> moves,
                        detail::only<span<const basic_wheelset_loads<T>>> loads,
                        basic_wheelset_workspace<T> &workspace, detail::only<span<basic_wheel_position<T>>> to,
                        detail::only<span<basic_wheel_velocity<T>>> to_moves, span<std::int32_t> statuses,
                        detail::only<basic_wheelset_forces<T>> *to_forces = nullptr) noexcept
{
    const std::size_t count = to.size();
    if (!detail::fit(count, start, moves, loads) || to_moves.size() != count || statuses.size() != count)
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_wheelsets_settle, &set, &rails, detail::capacity(count), start.data(),
                           detail::spacing(start), moves.data(), detail::spacing(moves), loads.data(),
                           detail::spacing(loads), &workspace, to.data(), to_moves.data(), to_forces, statuses.data());
}

/// `statuses`: as many as there are shifts; empty: not needed. Returns error_capacity if the arrays have different sizes.
template <class T>
status rolling_radius_difference(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                 detail::only<lengths<T>> shifts, bool with_roll,
                                 basic_wheelset_workspace<T> &workspace,
                                 detail::only<span<basic_metres<T>>> to, span<std::int32_t> statuses = {}) noexcept
{
    if (shifts.size() != to.size() || !detail::fits(shifts.size()) || !detail::are_for(statuses, to.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_rolling_radius_difference, &set, &rails, shifts.data(),
                           detail::capacity(shifts.size()), with_roll ? 1 : 0, &workspace, to.data(), statuses.data());
}

/// `wave_lengths`, `statuses`: as many as there are amplitudes; null and empty: not needed. Returns error_capacity where arrays have
/// different sizes.
template <class T>
status equivalent_conicity(detail::only<lengths<T>> shifts,
                           detail::only<lengths<T>> differences, basic_metres<T> running_circles,
                           detail::only<basic_metres<T>> wheel_radius, detail::only<lengths<T>> amplitudes,
                           detail::only<span<T>> to, detail::only<basic_metres<T>> *wave_lengths = nullptr,
                           span<std::int32_t> statuses = {}) noexcept
{
    if (shifts.size() != differences.size() || amplitudes.size() != to.size() || !detail::fits(shifts.size()) ||
        !detail::fits(to.size()) || !detail::are_for(statuses, to.size()))
        return status::error_capacity;
    return KSTRIP_HPP_CALL(kstrip_equivalent_conicity, shifts.data(), differences.data(),
                           detail::capacity(shifts.size()), running_circles, wheel_radius, amplitudes.data(),
                           detail::capacity(to.size()), to.data(), wave_lengths, statuses.data());
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// The form of gauge_face() that throws. A `depth` of 0 means 14 mm.
template <class T>
basic_metres<T> gauge_face(const basic_surface<T> &rail, detail::only<basic_metres<T>> depth = {})
KSTRIP_HPP_THROWING(basic_metres<T>, gauge_face, rail, depth, to)

/// Result of curve_motion().
template <class T>
struct basic_curve_motion {
    basic_wheel_velocity<T> velocity;
    std::array<T, 3> weight; ///< per mass: forward, lateral, vertical [m/s^2]
};
/// The form of curve_motion() that throws.
template <class T>
basic_curve_motion<T> curve_motion(const basic_curve<T> &through, const basic_wheel_position<T> &where,
                                   const basic_wheel_velocity<T> &relative)
KSTRIP_HPP_THROWING(basic_curve_motion<T>, curve_motion, through, where, relative, to.velocity, to.weight.data())

/// The forces alone.
template <class T>
basic_wheelset_forces<T> wheelset_on_track(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                           const basic_wheel_position<T> &where, const basic_wheel_velocity<T> &moves,
                                           basic_wheelset_workspace<T> &workspace)
KSTRIP_HPP_THROWING(basic_wheelset_forces<T>, wheelset_on_track, set, rails, where, moves, workspace, to)

/// The forces with their derivatives.
template <class T>
struct basic_wheelset_evaluation {
    basic_wheelset_forces<T> forces;
    basic_wheelset_derivatives<T> derivatives; ///< with respect to velocities and friction
    basic_wheelset_by_position<T> by_position; ///< zero unless they are requested
};
/// `by_position`: whether to compute the derivatives with respect to the positions too.
template <class T>
basic_wheelset_evaluation<T> wheelset_on_track_with_derivatives(
    const basic_wheelset<T> &set, const basic_track<T> &rails, const basic_wheel_position<T> &where,
    const basic_wheel_velocity<T> &moves, basic_wheelset_workspace<T> &workspace, bool by_position = false)
KSTRIP_HPP_THROWING(basic_wheelset_evaluation<T>, wheelset_on_track, set, rails, where, moves, workspace, to.forces,
                    &to.derivatives, by_position ? &to.by_position : nullptr)

/// A wheelset in balance: the result of wheelset_settle().
template <class T>
struct basic_settled {
    basic_wheel_position<T> position;
    basic_wheel_velocity<T> velocity;
    basic_wheelset_forces<T> forces;
};
/// The form of wheelset_settle() that throws.
template <class T>
basic_settled<T> wheelset_settle(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                 const basic_wheel_position<T> &start, const basic_wheel_velocity<T> &moves,
                                 const basic_wheelset_loads<T> &loads, basic_wheelset_workspace<T> &workspace)
KSTRIP_HPP_THROWING(basic_settled<T>, wheelset_settle, set, rails, start, moves, loads, workspace, to.position,
                    to.velocity, &to.forces)

/// The forces at many positions. `where`, `moves`: one element for all, or one for each.
template <class T>
results<basic_wheelset_forces<T>> wheelsets_on_track(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                                     detail::only<span<const basic_wheel_position<T>>> where,
                                                     detail::only<span<const basic_wheel_velocity<T>>> moves,
                                                     basic_wheelset_workspace<T> &workspace)
{
    const std::size_t count = detail::largest(where, moves);
    results<basic_wheelset_forces<T>> found(count);
    found.statuses = detail::each_status(count, [&](span<std::int32_t> statuses) {
        return wheelsets_on_track<T>(set, rails, where, moves, workspace,
                                     span<basic_wheelset_forces<T>>(found.data(), count), statuses);
    });
    return found;
}

/// Result of wheelsets_settle(): one element for each balance.
template <class T>
struct basic_many_settled {
    std::vector<basic_wheel_position<T>> position;
    std::vector<basic_wheel_velocity<T>> velocity;
    std::vector<basic_wheelset_forces<T>> forces;
    std::vector<status> statuses;
};
/// Many balances. Arrays: one element for all, or one for each.
template <class T>
basic_many_settled<T> wheelsets_settle(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                       detail::only<span<const basic_wheel_position<T>>> start,
                                       detail::only<span<const basic_wheel_velocity<T>>> moves,
                                       detail::only<span<const basic_wheelset_loads<T>>> loads,
                                       basic_wheelset_workspace<T> &workspace)
{
    const std::size_t count = detail::largest(start, moves, loads);
    basic_many_settled<T> found{std::vector<basic_wheel_position<T>>(count), std::vector<basic_wheel_velocity<T>>(count),
                                std::vector<basic_wheelset_forces<T>>(count), {}};
    found.statuses = detail::each_status(count, [&](span<std::int32_t> statuses) {
        return wheelsets_settle<T>(set, rails, start, moves, loads, workspace,
                                   span<basic_wheel_position<T>>(found.position.data(), count),
                                   span<basic_wheel_velocity<T>>(found.velocity.data(), count), statuses,
                                   found.forces.data());
    });
    return found;
}

/// The form of rolling_radius_difference() that throws.
template <class T>
results<basic_metres<T>> rolling_radius_difference(const basic_wheelset<T> &set, const basic_track<T> &rails,
                                                   detail::only<lengths<T>> shifts, bool with_roll,
                                                   basic_wheelset_workspace<T> &workspace)
{
    results<basic_metres<T>> to(shifts.size());
    to.statuses = detail::each_status(shifts.size(), [&](span<std::int32_t> statuses) {
        return rolling_radius_difference<T>(set, rails, shifts, with_roll, workspace,
                                            span<basic_metres<T>>(to.data(), to.size()), statuses);
    });
    return to;
}

/// Result of equivalent_conicity(): one for each amplitude.
template <class T>
struct basic_conicities {
    std::vector<T> conicities;
    std::vector<basic_metres<T>> wave_lengths; ///< infinite if the conicity is 0
    std::vector<status> statuses;
};
/// The form of equivalent_conicity() that throws.
template <class T>
basic_conicities<T> equivalent_conicity(detail::only<lengths<T>> shifts, detail::only<lengths<T>> differences,
                                        basic_metres<T> running_circles, detail::only<basic_metres<T>> wheel_radius,
                                        detail::only<lengths<T>> amplitudes)
{
    const std::size_t count = amplitudes.size();
    basic_conicities<T> to{std::vector<T>(count), std::vector<basic_metres<T>>(count), {}};
    to.statuses = detail::each_status(count, [&](span<std::int32_t> statuses) {
        return equivalent_conicity<T>(shifts, differences, running_circles, wheel_radius, amplitudes,
                                      span<T>(to.conicities.data(), count), to.wave_lengths.data(), statuses);
    });
    return to;
}
#endif

// ---- Test rigs: friction from a force, creepage from a force ----------------------------------

/// Which force components were measured.
enum class measured : std::uint32_t {
    fx = KSTRIP_MEASURED_FX,
    fy = KSTRIP_MEASURED_FY,
    both = KSTRIP_MEASURED_FX | KSTRIP_MEASURED_FY,
};

/// A coefficient of friction from a measured force. See kstrip_friction_estimate.
template <class T>
struct basic_friction_estimate {
    T friction;
    basic_per_newton<T> sensitivity;
    basic_newtons<T> residual;
    kstrip::status status_detail;
    std::int32_t reserved;
};
KSTRIP_HPP_BOTH(friction_estimate)

/// Calls kstrip_estimate_friction().
template <class T>
status estimate_friction(const basic_contact<T> &ellipse, const detail::only<basic_creepage<T>> &creep,
                         const detail::only<basic_friction<T>> *law, const options &how, measured what,
                         detail::only<basic_newtons<T>> fx, detail::only<basic_newtons<T>> fy,
                         basic_friction_estimate<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_estimate_friction, &ellipse, &creep, law, &how, static_cast<std::uint32_t>(what), fx,
                           fy, &to);
}

/// Calls kstrip_creepage_for_force().
template <class T>
status creepage_for_force(const basic_contact<T> &ellipse, detail::only<basic_newtons<T>> fx,
                          detail::only<basic_newtons<T>> fy, detail::only<basic_per_metre<T>> spin,
                          const detail::only<basic_friction<T>> *law, const options &how,
                          basic_creepage<T> &to) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_creepage_for_force, &ellipse, fx, fy, spin, law, &how, &to);
}

/// Which members of a law are fitted; added with |.
enum class fitted : std::uint32_t {
    coefficient = KSTRIP_FIT_FRICTION,
    ratio = KSTRIP_FIT_RATIO,
    decay = KSTRIP_FIT_DECAY,
    slope_factor = KSTRIP_FIT_SLOPE_FACTOR,
    slide_factor = KSTRIP_FIT_SLIDE_FACTOR,
    layer = KSTRIP_FIT_LAYER,
};

constexpr fitted operator|(fitted one, fitted other) noexcept
{
    return static_cast<fitted>(static_cast<std::uint32_t>(one) | static_cast<std::uint32_t>(other));
}

/// One measured point of a creep curve.
template <class T>
struct basic_measured_force {
    T longitudinal{};
    T lateral{};
    basic_per_metre<T> spin{};
    basic_newtons<T> fx{};
    basic_newtons<T> fy{};
    T weight = T(1);
    kstrip::measured measured = kstrip::measured::fx;
    std::uint32_t reserved = 0;
};
KSTRIP_HPP_BOTH(measured_force)

/// A law of friction that was fitted to measured points.
template <class T>
struct basic_friction_fit {
    basic_friction<T> law;
    basic_friction<T> standard_errors;
    basic_newtons<T> residual;
    std::uint32_t steps;
    kstrip::status status_detail;
};
KSTRIP_HPP_BOTH(friction_fit)

/// The law that fits measured points best; first_bad may be null.
template <class T>
status fit_friction(const basic_contact<T> &ellipse, const detail::only<basic_measured_force<T>> *points,
                    std::uint32_t count, const detail::only<basic_friction<T>> &start, fitted which,
                    const options &how, basic_friction_fit<T> &to, std::uint32_t *first_bad = nullptr) noexcept
{
    return KSTRIP_HPP_CALL(kstrip_fit_friction, &ellipse, points, count, &start, static_cast<std::uint32_t>(which),
                           &how, &to, first_bad);
}

#if defined(KSTRIP_HPP_EXCEPTIONS)
/// The form of estimate_friction() that throws.
template <class T>
basic_friction_estimate<T> estimate_friction(const basic_contact<T> &ellipse,
                                             const detail::only<basic_creepage<T>> &creep, measured what,
                                             detail::only<basic_newtons<T>> fx, detail::only<basic_newtons<T>> fy,
                                             const options &how = {},
                                             const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_friction_estimate<T>, estimate_friction, ellipse, creep, law, how, what, fx, fy, to)

/// The form of creepage_for_force() that throws.
template <class T>
basic_creepage<T> creepage_for_force(const basic_contact<T> &ellipse, detail::only<basic_newtons<T>> fx,
                                     detail::only<basic_newtons<T>> fy, detail::only<basic_per_metre<T>> spin,
                                     const options &how = {}, const detail::only<basic_friction<T>> *law = nullptr)
KSTRIP_HPP_THROWING(basic_creepage<T>, creepage_for_force, ellipse, fx, fy, spin, law, how, to)

template <class T>
basic_friction_fit<T> fit_friction(const basic_contact<T> &ellipse,
                                   const detail::only<basic_measured_force<T>> *points, std::uint32_t count,
                                   const detail::only<basic_friction<T>> &start, fitted which,
                                   const options &how = {})
KSTRIP_HPP_THROWING(basic_friction_fit<T>, fit_friction, ellipse, points, count, start, which, how, to)
#endif

// ---- Options, upper body, version: these cannot fail ------------------------------------------

inline constexpr int version_major = KSTRIP_VERSION_MAJOR;
inline constexpr int version_minor = KSTRIP_VERSION_MINOR;
inline constexpr int version_patch = KSTRIP_VERSION_PATCH;
inline constexpr int abi_version = KSTRIP_ABI_VERSION;

/// The defaults, like options{}.
inline options defaults() noexcept
{
    options to{};
    static_cast<void>(detail::call(kstrip_options_init, &to));
    return to;
}

/// Calls kstrip_result_on_upper_body().
template <class T>
basic_result<T> on_upper_body(const basic_result<T> &lower) noexcept
{
    basic_result<T> upper{};
    static_cast<void>(KSTRIP_HPP_CALL(kstrip_result_on_upper_body, &lower, &upper));
    return upper;
}

/// Version of the library that is linked.
inline const char *linked_version() noexcept { return kstrip_version_string(); }
/// Whether the library that is linked has the binary interface of this header.
inline bool linked_abi_matches() noexcept { return kstrip_abi_version() == KSTRIP_ABI_VERSION; }

#undef KSTRIP_HPP_CALL
#undef KSTRIP_HPP_SAME
#undef KSTRIP_HPP_BOTH
#undef KSTRIP_HPP_THROWING
} // namespace kstrip

#endif // KSTRIP_HPP
