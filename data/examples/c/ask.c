/* Asks libbioprint.so for each request named on the command line and prints the answers, one a line.
 *
 *     cc ask.c $(pkg-config --cflags --libs bioprint) -o ask
 *     ./ask '{"radius": "50um", "flowrate": "141uL/h"}'
 */
#include <bioprint/bioprint.h>
#include <stdio.h>

int main(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        char* answer = bioprint_predict_json(argv[i]);
        if (answer == NULL) return 1;
        puts(answer);
        bioprint_free(answer);
    }
    return 0;
}
