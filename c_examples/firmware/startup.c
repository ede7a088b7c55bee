/* From reset to main() on a Cortex-M with a floating-point unit, without any vendor's code.
 *
 * Input and output are semihosting calls of the C library (newlib, --specs=rdimon.specs): the debugger
 * or QEMU prints, and main's value becomes the exit status of the simulator. On a board of your own
 * leave initialise_monitor_handles() and the calls of exit() out.
 */
#include <stdint.h>
#include <stdlib.h>

extern uint32_t stack_top[], data_image[], data_start[], data_end[], bss_start[], bss_end[];

int main(void);
void reset(void);
void initialise_monitor_handles(void);

/* Coprocessor access control: full access to CP10 and CP11, the floating-point unit. */
#define CPACR (*(volatile uint32_t *)0xE000ED88u)

void reset(void)
{
    uint32_t *to = data_start;
    const uint32_t *from = data_image;
    while (to < data_end) {
        *to++ = *from++;
    }
    for (to = bss_start; to < bss_end; ++to) {
        *to = 0;
    }
    CPACR |= 0xFu << 20;
    __asm volatile("dsb\n\tisb" ::: "memory");
    initialise_monitor_handles();
    exit(main());
}

/* Any fault ends the program with a status that no test takes for success. */
static void fault(void)
{
    _Exit(99);
}

/* newlib's start-up files would define these. */
void _init(void);
void _fini(void);
void _init(void) {}
void _fini(void) {}

typedef void (*handler)(void);

__attribute__((section(".vectors"), used)) static const struct {
    const uint32_t *stack;
    handler handlers[15];
} vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault},
};
