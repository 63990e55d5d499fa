/* From reset to main on an STM32F405 (Cortex-M4F). Standard output goes through semihosting. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

extern uint32_t stack_top, data_load, data_start, data_end, bss_start, bss_end;
extern void initialise_monitor_handles(void);
extern int main(void);

/* The C library wants them; there is nothing to set up or tear down. */
void _init(void) {}
void _fini(void) {}

static void reset(void)
{
    static char line[160];
    volatile uint32_t *cpacr = (volatile uint32_t *)0xE000ED88u;
    *cpacr |= 0xFu << 20; /* float instructions are off after reset */
    __asm volatile("dsb\n\tisb");
    memcpy(&data_start, &data_load, (size_t)((char *)&data_end - (char *)&data_start));
    memset(&bss_start, 0, (size_t)((char *)&bss_end - (char *)&bss_start));
    initialise_monitor_handles();
    setvbuf(stdout, line, _IOLBF, sizeof line);
    exit(main());
}

static void fault(void)
{
    puts("fault");
    exit(4);
}

/* What the library calls if it finds a defect of its own. */
__attribute__((noreturn)) void horus_panic(void);
void horus_panic(void)
{
    puts("horus_panic");
    exit(3);
}

typedef union {
    void (*handler)(void);
    void *address;
} vector;

/* Stack, reset, NMI, and the faults; no interrupt is ever enabled. */
__attribute__((section(".vectors"), used)) static const vector vectors[] = {
    { .address = &stack_top }, { .handler = reset }, { .handler = fault }, { .handler = fault },
    { .handler = fault },      { .handler = fault }, { .handler = fault },
};
