/* Prints the text of every status, and the version. */
#include "kstrip_f32.h"
#include <stdio.h>

int main(void)
{
    for (int status = -100; status <= 40; status++)
        printf("text %d %s\n", status, kstrip_status_string(status));
    printf("version %s abi %ld\n", kstrip_version_string(), (long)kstrip_abi_version());
    return 0;
}
