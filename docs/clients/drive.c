/* A closed loop with lunoid, in C: drive ahead, look, decide, drive on.
 * lunoid serve scenarios/first-light.toml --tcp 7070 --record runs/driven, with a word of 16 characters or more in LUNOID_TOKEN; then
 * cc -o drive docs/clients/drive.c && LUNOID_TOKEN=... ./drive 50 7070 */
#include <arpa/inet.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int line, asked;                       /* socket, number of the last request */
static unsigned char *reply;                  /* header, a zero, then the bytes of all planes */
static void end(const char *why) { fprintf(stderr, "%s\n", why); exit(1); }

static void take(void *to, size_t count) {
    for (ssize_t n; count > 0; to = (char *)to + n, count -= (size_t)n)
        if ((n = read(line, to, count)) <= 0) end("lunoid serve has ended");
}

/* Sends {"id":N,KEYS}; the header of the reply. Bytes of the planes: their count in *planes. Little-endian computers only. */
static char *ask(const char *keys, uint64_t *planes) {
    static char bytes[65536];
    uint64_t length[2];
    int count = snprintf(bytes + 24, sizeof bytes - 24, "{\"id\":%d,%s}", ++asked, keys);
    length[0] = (uint64_t)count, length[1] = 0;
    memcpy(bytes, "lunoid.1", 8), memcpy(bytes + 8, length, 16);
    if (write(line, bytes, 24 + (size_t)count) != 24 + count) end("lunoid serve does not listen");
    take(bytes, 24), memcpy(length, bytes + 8, 16);
    reply = realloc(reply, length[0] + length[1] + 1);
    take(reply, length[0]), reply[length[0]] = 0, take(reply + length[0] + 1, length[1]);
    if (strstr((char *)reply, "\"error\":")) end((char *)reply);
    return *planes = length[1], (char *)reply;
}

/* The text of a value of a reply, from `"key":` up to and with `last`. */
static void value(const char *header, const char *key, char last, char *to, size_t room) {
    const char *from = strstr(header, key), *until = from ? strchr(from + strlen(key) + 1, last) : NULL;
    if (!until || (size_t)(until - from) >= room) end(key);
    snprintf(to, room, "%.*s", (int)(until + 1 - from - strlen(key)), from + strlen(key));
}

int main(int count, char **words) {
    char keys[4096], pose[1024], hash[128];
    const char *token = getenv("LUNOID_TOKEN");
    struct sockaddr_in to = {.sin_family = AF_INET, .sin_port = htons((uint16_t)atoi(count > 2 ? words[2] : "0"))};
    uint64_t planes;
    if (count != 3 || !token) end("LUNOID_TOKEN=... drive STEPS PORT");
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK), line = socket(AF_INET, SOCK_STREAM, 0);
    if (connect(line, (struct sockaddr *)&to, sizeof to)) end("nobody listens at the port");
    snprintf(keys, sizeof keys, "\"do\":\"hello\",\"token\":\"%s\"", token), ask(keys, &planes);
    value(ask("\"do\":\"frame\",\"frame\":0", &planes), "\"pose\":", '}', pose, sizeof pose);
    for (int step = 0; step < atoi(words[1]); step++) {
        snprintf(keys, sizeof keys, "\"do\":\"step\",\"pose\":%s", pose);
        value(ask(keys, &planes), "\"hash\":", '"', hash, sizeof hash);
        printf("%s %llu\n", strtok(hash, "\""), (unsigned long long)planes);
        snprintf(keys, sizeof keys, "\"do\":\"ahead\",\"metres\":0.5,\"turn_deg\":0.5,\"pose\":%s", pose);
        value(ask(keys, &planes), "\"pose\":", '}', pose, sizeof pose); /* your controller here */
    }
    puts(ask("\"do\":\"record\"", &planes));
}
