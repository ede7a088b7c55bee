# CMake toolchain for a bare Cortex-M4F or Cortex-M7:
#     cmake -S c_examples/firmware -B build -DCMAKE_TOOLCHAIN_FILE=arm-none-eabi.cmake \
#         -DKSTRIP_LIBRARY=<path of libkstrip.a> [-DCORE=cortex-m7]
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
# There is no system to link test programs for.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(CORE cortex-m4 CACHE STRING "cortex-m4 or cortex-m7")
if(CORE STREQUAL "cortex-m7")
    set(FPU fpv5-d16)
else()
    set(FPU fpv4-sp-d16)
endif()
set(CMAKE_C_FLAGS_INIT "-mcpu=${CORE} -mfpu=${FPU} -mthumb -mfloat-abi=hard -ffp-contract=off")
