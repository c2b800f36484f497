#ifndef BIOPRINT_BIOPRINT_H
#define BIOPRINT_BIOPRINT_H

/** The predictor for any language that can call C: text in, text out.
 *
 *     char* answer = bioprint_predict_json("{\"radius\": \"50um\", \"flowrate\": \"141uL/h\"}");
 *     puts(answer);
 *     bioprint_free(answer);
 *
 * The request is one JSON object, as a line of a JSON Lines batch: its keys are the names of the command's
 * options without the dashes, or paths of the answer's `input`; its values are numbers (SI) or strings with a
 * unit. Whatever is not given has the command's default. The answer is one JSON object of schema
 * bioprint-predict/1, all of it SI.
 *
 * A request that cannot be answered yields an object with a member `error` (code, message, option): no call
 * throws, exits, prints, or depends on the locale. Calls from several threads do not disturb each other.
 */
#ifdef __cplusplus
extern "C" {
#endif

/** Answers one request.
 * @param request  JSON in UTF-8, ended by NUL
 * @return the answer in UTF-8, ended by NUL, to be freed by bioprint_free; NULL only when there is no memory
 * for it
 */
char* bioprint_predict_json(const char* request);

/** Frees an answer; NULL is allowed. */
void bioprint_free(char* answer);

/** The version of the library, such as "1.0.0"; not to be freed. */
const char* bioprint_version(void);

#ifdef __cplusplus
}
#endif

#endif
