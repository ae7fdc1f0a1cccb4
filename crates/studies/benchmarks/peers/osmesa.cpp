// A mesh drawn by OSMesa, OpenGL in software: one vertex buffer, one draw call, one sample a pixel.
//
//   osmesa SCENE
//
// SCENE is what src/peers/embree/scene_file.rs writes, as peers/embree.cpp reads it. The first number of a normal is the light of its
// vertex. Each face is one triangle and repeats its last vertex, or two. Light runs over a triangle as it does in space.
//
// It makes a context, prints "ready SECONDS", and answers each line of its input with one line:
//
//   show           draws a frame of the buffer that is there, up to its read-back: SECONDS
//   show anew      the same with a vertex buffer that is filled anew: SECONDS
//   texture COLUMNS LINES PATH   reads a texture, floats line by line from the top left; from now on the first two numbers of a normal are a
//                  place in it, whose light is taken between the four pixels around it: read
//   picture PATH   writes the last frame as floats, line by line from the top left: written
//
// The picture has 8 bits a colour. Two threads shade pixels.

#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr const char *THREADS = "2";

struct Header {
    std::uint32_t magic, vertices, faces, columns, lines;
    float half_width, half_height, albedo, start, end;
    float forward[3], starboard[3], down[3];
};

constexpr std::uint32_t MAGIC = 0x48534d4c;

/// Place and normal, of which OpenGL takes the first number as red.
struct Vertex {
    float place[3], normal[3];
};

[[noreturn]] void fail(const std::string &why) {
    std::cerr << "osmesa: " << why << '\n';
    std::exit(1);
}

struct Scene {
    Header header;
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> corners;
};

Scene read(const char *path) {
    std::ifstream file(path, std::ios::binary);
    Scene scene;
    auto part = [&](void *to, std::size_t size) {
        if (!file.read(static_cast<char *>(to), static_cast<std::streamsize>(size))) fail(std::string(path) + ": too short");
    };
    part(&scene.header, sizeof(Header));
    if (scene.header.magic != MAGIC) fail(std::string(path) + ": no scene");
    scene.vertices.resize(scene.header.vertices);
    std::vector<std::uint32_t> faces(4 * static_cast<std::size_t>(scene.header.faces));
    part(scene.vertices.data(), scene.vertices.size() * sizeof(Vertex));
    part(faces.data(), faces.size() * sizeof(std::uint32_t));
    for (std::size_t face = 0; face < faces.size(); face += 4) {
        const std::uint32_t *at = faces.data() + face;
        scene.corners.insert(scene.corners.end(), {at[0], at[1], at[3]});
        if (at[2] != at[3]) scene.corners.insert(scene.corners.end(), {at[1], at[2], at[3]});
    }
    return scene;
}

float along(const float axis[3], const Vertex &vertex) {
    return axis[0] * vertex.place[0] + axis[1] * vertex.place[1] + axis[2] * vertex.place[2];
}

/// From places before the eye to the screen; depth goes from the nearest to the farthest vertex.
void look(const Scene &scene) {
    const Header &header = scene.header;
    float near = INFINITY, far = 0.0f;
    for (const Vertex &vertex : scene.vertices) {
        const float ahead = along(header.forward, vertex);
        if (ahead > 0.0f) near = std::min(near, ahead), far = std::max(far, ahead);
    }
    near *= 0.99f, far *= 1.01f;
    const float depth = (far + near) / (far - near), shift = -2.0f * far * near / (far - near);
    float matrix[16] = {};
    for (int axis = 0; axis < 3; axis++) {
        matrix[4 * axis] = header.starboard[axis] / header.half_width;
        matrix[4 * axis + 1] = -header.down[axis] / header.half_height;
        matrix[4 * axis + 2] = depth * header.forward[axis];
        matrix[4 * axis + 3] = header.forward[axis];
    }
    matrix[14] = shift;
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixf(matrix);
    glEnable(GL_DEPTH_TEST);
}

void fill(const Scene &scene) {
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.vertices.size() * sizeof(Vertex)), scene.vertices.data(), GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(scene.corners.size() * sizeof(std::uint32_t)), scene.corners.data(),
                 GL_STREAM_DRAW);
}

/// Makes the buffers, and says where places and light stand in them.
void bind(const Scene &scene) {
    GLuint buffers[2];
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    fill(scene);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void *>(offsetof(Vertex, place)));
    glColorPointer(3, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void *>(offsetof(Vertex, normal)));
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
}

/// Reads the texture that `line` asks for, in 8 bits as the picture has, and lays it over everything.
void lay(const std::string &line) {
    std::istringstream words(line);
    std::string what, path;
    GLsizei columns = 0, lines = 0;
    words >> what >> columns >> lines >> path;
    std::vector<float> lights(static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines));
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char *>(lights.data()), static_cast<std::streamsize>(lights.size() * sizeof(float)))) fail(path + ": too short");
    std::vector<std::uint8_t> codes(lights.size());
    std::transform(lights.begin(), lights.end(), codes.begin(), [](float light) { return static_cast<std::uint8_t>(std::lround(255.0f * light)); });
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_LUMINANCE8, columns, lines, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, codes.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glEnable(GL_TEXTURE_2D);
    glMatrixMode(GL_TEXTURE);
    glLoadIdentity();
    glScalef(1.0f / static_cast<float>(columns), 1.0f / static_cast<float>(lines), 1.0f);
    glDisableClientState(GL_COLOR_ARRAY);
    glColor3f(1.0f, 1.0f, 1.0f);
    glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void *>(offsetof(Vertex, normal)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    if (glGetError() != GL_NO_ERROR) fail(path + ": no texture could be made of it");
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

int main(int count, char **arguments) {
    if (count != 2) fail("expected one argument, the scene");
    setenv("LP_NUM_THREADS", THREADS, 1);
    const auto begin = std::chrono::steady_clock::now();
    const Scene scene = read(arguments[1]);
    const GLsizei columns = static_cast<GLsizei>(scene.header.columns), lines = static_cast<GLsizei>(scene.header.lines);
    std::vector<std::uint8_t> picture(4 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(lines));
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
    if (!context || !OSMesaMakeCurrent(context, picture.data(), GL_UNSIGNED_BYTE, columns, lines)) fail("no context");
    OSMesaPixelStore(OSMESA_Y_UP, 0);
    glViewport(0, 0, columns, lines);
    look(scene);
    bind(scene);
    if (glGetError() != GL_NO_ERROR) fail("the buffers could not be made");
    std::cout << "ready " << seconds_since(begin) << std::endl;

    for (std::string line; std::getline(std::cin, line);) {
        if (line == "show" || line == "show anew") {
            const auto begin = std::chrono::steady_clock::now();
            if (line == "show anew") fill(scene);
            glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(scene.corners.size()), GL_UNSIGNED_INT, nullptr);
            // The picture of a context in memory is there when everything is finished.
            glFinish();
            const double seconds = seconds_since(begin);
            if (glGetError() != GL_NO_ERROR) fail("the frame could not be drawn");
            std::cout << seconds << std::endl;
        } else if (line.rfind("texture ", 0) == 0) {
            lay(line);
            std::cout << "read" << std::endl;
        } else if (line.rfind("picture ", 0) == 0) {
            const std::string path = line.substr(8);
            std::vector<float> light(picture.size() / 4);
            for (std::size_t pixel = 0; pixel < light.size(); pixel++) light[pixel] = static_cast<float>(picture[4 * pixel]) / 255.0f;
            std::ofstream file(path, std::ios::binary);
            file.write(reinterpret_cast<const char *>(light.data()), static_cast<std::streamsize>(light.size() * sizeof(float)));
            if (!file.flush()) fail(path + ": cannot be written");
            std::cout << "written" << std::endl;
        } else {
            fail("expected 'show', 'show anew', 'texture COLUMNS LINES PATH' or 'picture PATH', found '" + line + "'");
        }
    }
    OSMesaDestroyContext(context);
}
