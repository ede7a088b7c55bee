# The C++ reference from kstrip.hpp: `doxygen docs/Doxyfile.cpp` writes target/doxygen-cpp/html. Any warning is an error.
@INCLUDE               = docs/Doxyfile
PROJECT_BRIEF          = "Creep forces of rolling contact by Kalker's strip theory: C++"
OUTPUT_DIRECTORY       = target/doxygen-cpp
INPUT                  = include/kstrip.hpp include/kstrip.h
FILE_PATTERNS          = *.hpp *.h
OPTIMIZE_OUTPUT_FOR_C  = NO
# Members have the names, units and meanings of their C namesakes, to which each structure links.
EXTRACT_ALL            = YES
MACRO_EXPANSION        = YES
EXPAND_ONLY_PREDEF     = YES
EXCLUDE_SYMBOLS        = kstrip::detail kstrip::unit
PREDEFINED             = "KSTRIP_HPP_EXCEPTIONS=1" \
                         "__cplusplus=201703L" \
                         "KSTRIP_HPP_BOTH(name)=using name = basic_##name<double>; using name##_f32 = basic_##name<float>;" \
                         "KSTRIP_HPP_SAME(cpp, c)=" \
                         "KSTRIP_HPP_THROWING(outputs, call, ...)=;" \
                         "KSTRIP_HPP_UNIT(name)=template <class T> using basic_##name = quantity<unit::name, T>; using name = basic_##name<double>; using name##_f32 = basic_##name<float>;" \
                         "KSTRIP_HPP_LITERAL(suffix, type, divisor, factor)="
