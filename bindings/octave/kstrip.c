/* kstrip in MATLAB and Octave: forces and their derivatives of many contacts.
 *
 *   make && mkoctfile --mex -Iinclude bindings/octave/kstrip.c target/lib/libkstrip.a -o target/kstrip.mex
 *   mex -Iinclude bindings/octave/kstrip.c target/lib/libkstrip.a                          (MATLAB)
 *
 *   [force, jacobian] = kstrip(contact, creepage, model)
 *
 * contact   6 x n or 6 x 1: a, b [m], normal force [N], shear modulus [Pa], Poisson's ratio, friction
 * creepage  3 x n: longitudinal, lateral, spin [1/m]
 * model     a KSTRIP_MODEL number; left out: the default
 * force     3 x n on the lower body: fx, fy [N], mz [N m]
 * jacobian  3 x 3 x n: jacobian(i, j, k) is the derivative of force i by creepage j of contact k
 */
#include "kstrip.h"
#include "mex.h"

void mexFunction(int outputs, mxArray *output[], int inputs, const mxArray *input[])
{
    if (inputs < 2 || inputs > 3 || !mxIsDouble(input[0]) || !mxIsDouble(input[1]) || mxGetM(input[0]) != 6 || mxGetM(input[1]) != 3)
        mexErrMsgTxt("kstrip(contact, creepage, model): contact is 6 x n or 6 x 1, creepage 3 x n");
    const size_t count = mxGetN(input[1]), contacts = mxGetN(input[0]);
    if (contacts != 1 && contacts != count) mexErrMsgTxt("kstrip: contact and creepage have different numbers of columns");
    const kstrip_options options = {inputs > 2 ? (int32_t)mxGetScalar(input[2]) : KSTRIP_MODEL_DEFAULT, 0};
    const mwSize sizes[3] = {3, 3, count};
    output[0] = mxCreateDoubleMatrix(3, count, mxREAL);
    double *force = mxGetPr(output[0]), *jacobian = NULL;
    if (outputs > 1) jacobian = mxGetPr(output[1] = mxCreateNumericArray(3, sizes, mxDOUBLE_CLASS, mxREAL));
    for (size_t k = 0; k < count; k++) {
        const double *c = mxGetPr(input[0]) + (contacts > 1 ? 6 * k : 0), *v = mxGetPr(input[1]) + 3 * k;
        const kstrip_contact contact = {c[0], c[1], c[2], c[3], c[4], c[5]};
        const kstrip_creepage creepage = {v[0], v[1], v[2]};
        kstrip_result result;
        kstrip_derivatives derivatives;
        const kstrip_outputs wanted = {.result = &result, .derivatives = jacobian ? &derivatives : NULL};
        const kstrip_status status = kstrip_evaluate(&contact, &creepage, NULL, &options, &wanted);
        if (status < 0) mexErrMsgIdAndTxt("kstrip:status", "kstrip: column %d: %s", (int)k + 1, kstrip_status_string(status));
        const double f[3] = {result.fx, result.fy, result.mz};
        for (int i = 0; i < 3; i++) {
            force[3 * k + i] = f[i];
            for (int j = 0; jacobian && j < 3; j++) jacobian[9 * k + 3 * j + i] = derivatives.jacobian[i][j];
        }
    }
}
