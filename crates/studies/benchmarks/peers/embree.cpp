// A ray tracer over Embree 3: a mesh with smooth normals under one sun, with cast shadows, or one whose vertices send light of their own.
//
//   embree SCENE
//
// SCENE is what src/peers/embree/scene_file.rs writes, little-endian: header, then for each vertex its place and its normal, then for
// each face the numbers of four vertices. A face is two triangles, which share its second and its last vertex; a triangle repeats its
// last vertex. Axes: x north, y east, z up, metres, the eye at the origin.
//
// It divides space once, prints "built SECONDS", and answers each line of its input with one line:
//
//   trace PACKET NORTH EAST UP   traces a frame by packets of 16, 8 or 1 rays under the sun of that direction: SECONDS
//   show PACKET                  traces a frame without sun: the first number of a normal is the light of its vertex: SECONDS
//   texture COLUMNS LINES PATH   reads a texture, floats line by line from the top left: read
//   drape PACKET                 traces a frame without sun: the first two numbers of a normal are a place in the texture, whose light is
//                                taken between the four pixels around it: SECONDS
//   light PACKET NORTH EAST UP LIFT   one ray from each vertex to the sun of that direction, from LIFT metres on; the picture has a value for
//                                each vertex, 1 where nothing is in the way: SECONDS
//   divide QUALITY               divides space anew, of quality low, medium or high: SECONDS
//   picture PATH                 writes the last frame as floats, line by line from the top left: written
//
// A frame is one ray for each pixel, through its centre, and one to the sun from each place that faces it. Rays of a packet are those
// of a rectangle of pixels. Two threads take tiles in turn. Nothing of a frame is kept for the next.

#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr unsigned THREADS = 2;
/// Pixels along a side of the tiles that threads take.
constexpr unsigned TILE = 16;
/// A ray to the sun begins so far from where it starts, as a share of the distance from the eye: a face does not shade itself.
constexpr float LIFT = 1e-3f;

struct Header {
    std::uint32_t magic, vertices, faces, columns, lines;
    /// Tangents of half the field of view.
    float half_width, half_height;
    /// Share of the light that the ground returns.
    float albedo;
    /// Ground ranges between which the ground is seen (m).
    float start, end;
    float forward[3], starboard[3], down[3];
};

constexpr std::uint32_t MAGIC = 0x48534d4c;

struct Vertex {
    float place[3], normal[3];
};

struct Face {
    std::uint32_t corners[4];
};

struct Scene {
    Header header;
    std::vector<Vertex> vertices;
    std::vector<Face> faces;
};

[[noreturn]] void fail(const std::string &why) {
    std::cerr << "embree: " << why << '\n';
    std::exit(1);
}

Scene read(const char *path) {
    std::ifstream file(path, std::ios::binary);
    Scene scene;
    auto part = [&](void *to, std::size_t size) {
        if (!file.read(static_cast<char *>(to), static_cast<std::streamsize>(size))) fail(std::string(path) + ": too short");
    };
    part(&scene.header, sizeof(Header));
    if (scene.header.magic != MAGIC) fail(std::string(path) + ": no scene");
    scene.vertices.resize(scene.header.vertices);
    scene.faces.resize(scene.header.faces);
    part(scene.vertices.data(), scene.vertices.size() * sizeof(Vertex));
    part(scene.faces.data(), scene.faces.size() * sizeof(Face));
    return scene;
}

/// Space divided over the faces. Where all of them are triangles, Embree takes them as such.
RTCScene divide(RTCDevice device, const Scene &scene, RTCBuildQuality quality) {
    const bool triangles = std::all_of(scene.faces.begin(), scene.faces.end(), [](const Face &face) { return face.corners[2] == face.corners[3]; });
    RTCGeometry mesh = rtcNewGeometry(device, triangles ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD);
    // Embree asks for four readable bytes behind the last place: the normal follows it.
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, scene.vertices.data(), 0, sizeof(Vertex),
                               scene.vertices.size());
    rtcSetSharedGeometryBuffer(mesh, RTC_BUFFER_TYPE_INDEX, 0, triangles ? RTC_FORMAT_UINT3 : RTC_FORMAT_UINT4, scene.faces.data(), 0,
                               sizeof(Face), scene.faces.size());
    rtcSetGeometryBuildQuality(mesh, quality);
    rtcCommitGeometry(mesh);
    RTCScene space = rtcNewScene(device);
    rtcSetSceneBuildQuality(space, quality);
    rtcAttachGeometry(space, mesh);
    rtcReleaseGeometry(mesh);
    rtcCommitScene(space);
    return space;
}

/// Packets of `N` rays: their types and calls, and the sides of the rectangles of pixels that they cover.
template <unsigned N> struct Packet;

template <> struct Packet<16> {
    using Hits = RTCRayHit16;
    using Rays = RTCRay16;
    static constexpr unsigned WIDE = 8, HIGH = 2;
    static void meet(const int *valid, RTCScene space, RTCIntersectContext *context, Hits *hits) {
        rtcIntersect16(valid, space, context, hits);
    }
    static void shade(const int *valid, RTCScene space, RTCIntersectContext *context, Rays *rays) {
        rtcOccluded16(valid, space, context, rays);
    }
};

template <> struct Packet<8> {
    using Hits = RTCRayHit8;
    using Rays = RTCRay8;
    static constexpr unsigned WIDE = 4, HIGH = 2;
    static void meet(const int *valid, RTCScene space, RTCIntersectContext *context, Hits *hits) {
        rtcIntersect8(valid, space, context, hits);
    }
    static void shade(const int *valid, RTCScene space, RTCIntersectContext *context, Rays *rays) {
        rtcOccluded8(valid, space, context, rays);
    }
};

template <> struct Packet<1> {
    /// One ray, in the form of a packet.
    struct Rays {
        float org_x[1], org_y[1], org_z[1], tnear[1], dir_x[1], dir_y[1], dir_z[1], time[1], tfar[1];
        unsigned mask[1], id[1], flags[1];
    };
    struct Hits {
        Rays ray;
        struct {
            float u[1], v[1];
            unsigned primID[1], geomID[1];
        } hit;
    };
    static constexpr unsigned WIDE = 1, HIGH = 1;
    static RTCRay one(const Rays &rays) {
        return {rays.org_x[0], rays.org_y[0], rays.org_z[0], rays.tnear[0], rays.dir_x[0], rays.dir_y[0],
                rays.dir_z[0], rays.time[0],  rays.tfar[0],  rays.mask[0],  rays.id[0],    rays.flags[0]};
    }
    static void meet(const int *valid, RTCScene space, RTCIntersectContext *context, Hits *hits) {
        if (!valid[0]) return;
        RTCRayHit found;
        found.ray = one(hits->ray);
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(space, context, &found);
        hits->ray.tfar[0] = found.ray.tfar;
        hits->hit.u[0] = found.hit.u;
        hits->hit.v[0] = found.hit.v;
        hits->hit.primID[0] = found.hit.primID;
        hits->hit.geomID[0] = found.hit.geomID;
    }
    static void shade(const int *valid, RTCScene space, RTCIntersectContext *context, Rays *rays) {
        if (!valid[0]) return;
        RTCRay found = one(*rays);
        rtcOccluded1(space, context, &found);
        rays->tfar[0] = found.tfar;
    }
};

/// A picture that is laid over a mesh.
struct Texture {
    unsigned columns = 0, lines = 0;
    std::vector<float> lights;

    /// Light at a place in pixels, between the centres around it; beside the picture that of its edge.
    float at(float across, float down) const {
        const float i = std::clamp(across - 0.5f, 0.0f, static_cast<float>(columns - 1)),
                    j = std::clamp(down - 0.5f, 0.0f, static_cast<float>(lines - 1));
        const unsigned left = static_cast<unsigned>(i), top = static_cast<unsigned>(j);
        const unsigned right = std::min(left + 1, columns - 1), bottom = std::min(top + 1, lines - 1);
        const float u = i - static_cast<float>(left), v = j - static_cast<float>(top);
        const float *above = &lights[static_cast<std::size_t>(top) * columns], *below = &lights[static_cast<std::size_t>(bottom) * columns];
        const float first = above[left] + u * (above[right] - above[left]), second = below[left] + u * (below[right] - below[left]);
        return first + v * (second - first);
    }
};

/// What a frame asks.
enum class Work { Sun, OwnLight, Texture, Vertices };

/// A frame that threads trace together.
struct Frame {
    const Scene &scene;
    RTCScene space;
    /// Direction of the sun; of no length where vertices have light of their own.
    float sun[3];
    Work work;
    /// Where rays from vertices begin (m).
    float lift;
    const Texture &texture;
    std::vector<float> &picture;
    std::atomic<unsigned> next{0};
};

/// Traces the packet whose pixels begin at `column`, `line`.
template <unsigned N> void trace_packet(Frame &frame, RTCIntersectContext &context, unsigned column, unsigned line) {
    using P = Packet<N>;
    const Header &header = frame.scene.header;
    const float infinity = std::numeric_limits<float>::infinity();
    alignas(64) int valid[N];
    alignas(64) typename P::Hits hits;
    for (unsigned i = 0; i < N; i++) {
        const unsigned x = column + i % P::WIDE, y = line + i / P::WIDE;
        valid[i] = x < header.columns && y < header.lines ? -1 : 0;
        const float right = header.half_width * (static_cast<float>(2 * x + 1) / static_cast<float>(header.columns) - 1.0f);
        const float below = header.half_height * (static_cast<float>(2 * y + 1) / static_cast<float>(header.lines) - 1.0f);
        const float north = header.forward[0] + right * header.starboard[0] + below * header.down[0];
        const float east = header.forward[1] + right * header.starboard[1] + below * header.down[1];
        const float up = header.forward[2] + right * header.starboard[2] + below * header.down[2];
        const float level = 1.0f / std::sqrt(north * north + east * east);
        hits.ray.org_x[i] = hits.ray.org_y[i] = hits.ray.org_z[i] = 0.0f;
        hits.ray.dir_x[i] = north;
        hits.ray.dir_y[i] = east;
        hits.ray.dir_z[i] = up;
        hits.ray.tnear[i] = header.start * level;
        hits.ray.tfar[i] = header.end * level;
        hits.ray.time[i] = 0.0f;
        hits.ray.mask[i] = ~0u;
        hits.ray.id[i] = i;
        hits.ray.flags[i] = 0;
        hits.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    P::meet(valid, frame.space, &context, &hits);

    alignas(64) int facing[N];
    alignas(64) float light[N];
    alignas(64) typename P::Rays rays;
    int any = 0;
    for (unsigned i = 0; i < N; i++) {
        light[i] = 0.0f;
        facing[i] = 0;
        if (valid[i] && hits.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
            const std::uint32_t *corners = frame.scene.faces[hits.hit.primID[i]].corners;
            // Embree counts along both sides of the face: from the first corner, or beyond the diagonal from the third.
            const bool beyond = hits.hit.u[i] + hits.hit.v[i] > 1.0f;
            const float u = beyond ? 1.0f - hits.hit.u[i] : hits.hit.u[i], v = beyond ? 1.0f - hits.hit.v[i] : hits.hit.v[i],
                        w = 1.0f - u - v;
            const float *a = frame.scene.vertices[corners[beyond ? 2 : 0]].normal,
                        *b = frame.scene.vertices[corners[beyond ? 3 : 1]].normal,
                        *c = frame.scene.vertices[corners[beyond ? 1 : 3]].normal;
            if (frame.work == Work::OwnLight) {
                light[i] = w * a[0] + u * b[0] + v * c[0];
                continue;
            }
            if (frame.work == Work::Texture) {
                light[i] = frame.texture.at(w * a[0] + u * b[0] + v * c[0], w * a[1] + u * b[1] + v * c[1]);
                continue;
            }
            const float north = w * a[0] + u * b[0] + v * c[0], east = w * a[1] + u * b[1] + v * c[1],
                        up = w * a[2] + u * b[2] + v * c[2];
            const float towards = north * frame.sun[0] + east * frame.sun[1] + up * frame.sun[2];
            if (towards > 0.0f) {
                light[i] = header.albedo * towards / std::sqrt(north * north + east * east + up * up);
                facing[i] = any = -1;
            }
        }
    }
    if (any) {
        for (unsigned i = 0; i < N; i++) {
            const float t = hits.ray.tfar[i];
            rays.org_x[i] = t * hits.ray.dir_x[i];
            rays.org_y[i] = t * hits.ray.dir_y[i];
            rays.org_z[i] = t * hits.ray.dir_z[i];
            rays.dir_x[i] = frame.sun[0];
            rays.dir_y[i] = frame.sun[1];
            rays.dir_z[i] = frame.sun[2];
            rays.tnear[i] = LIFT * t;
            rays.tfar[i] = infinity;
            rays.time[i] = 0.0f;
            rays.mask[i] = ~0u;
            rays.id[i] = i;
            rays.flags[i] = 0;
        }
        P::shade(facing, frame.space, &context, &rays);
    }
    for (unsigned i = 0; i < N; i++) {
        if (!valid[i]) continue;
        // Embree sets the end of a ray that meets anything to minus infinity.
        const bool dark = facing[i] && rays.tfar[i] < 0.0f;
        const std::size_t pixel = static_cast<std::size_t>(line + i / P::WIDE) * header.columns + column + i % P::WIDE;
        frame.picture[pixel] = dark ? 0.0f : light[i];
    }
}

/// Traces tiles until none is left.
template <unsigned N> void trace_tiles(Frame &frame) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const Header &header = frame.scene.header;
    const unsigned across = (header.columns + TILE - 1) / TILE, down = (header.lines + TILE - 1) / TILE;
    for (unsigned tile = frame.next++; tile < across * down; tile = frame.next++) {
        const unsigned left = tile % across * TILE, top = tile / across * TILE;
        const unsigned right = std::min(left + TILE, header.columns), bottom = std::min(top + TILE, header.lines);
        for (unsigned line = top; line < bottom; line += Packet<N>::HIGH) {
            for (unsigned column = left; column < right; column += Packet<N>::WIDE) trace_packet<N>(frame, context, column, line);
        }
    }
}

/// Vertices that a thread takes at a time.
constexpr unsigned RUN = 1024;

/// One ray to the sun from each vertex, run by run.
template <unsigned N> void light_vertices(Frame &frame) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    const unsigned count = frame.scene.header.vertices;
    for (unsigned first = RUN * frame.next++; first < count; first = RUN * frame.next++) {
        const unsigned end = std::min(first + RUN, count);
        for (unsigned vertex = first; vertex < end; vertex += N) {
            alignas(64) int valid[N];
            alignas(64) typename Packet<N>::Rays rays;
            for (unsigned i = 0; i < N; i++) {
                valid[i] = vertex + i < end ? -1 : 0;
                const float *place = frame.scene.vertices[valid[i] ? vertex + i : vertex].place;
                rays.org_x[i] = place[0];
                rays.org_y[i] = place[1];
                rays.org_z[i] = place[2];
                rays.dir_x[i] = frame.sun[0];
                rays.dir_y[i] = frame.sun[1];
                rays.dir_z[i] = frame.sun[2];
                rays.tnear[i] = frame.lift;
                rays.tfar[i] = std::numeric_limits<float>::infinity();
                rays.time[i] = 0.0f;
                rays.mask[i] = ~0u;
                rays.id[i] = i;
                rays.flags[i] = 0;
            }
            Packet<N>::shade(valid, frame.space, &context, &rays);
            for (unsigned i = 0; i < N; i++) {
                if (valid[i]) frame.picture[vertex + i] = rays.tfar[i] < 0.0f ? 0.0f : 1.0f;
            }
        }
    }
}

template <unsigned N> void work_by(Frame &frame) {
    if (frame.work == Work::Vertices) light_vertices<N>(frame);
    else trace_tiles<N>(frame);
}

void trace_by(unsigned packet, Frame &frame) {
    if (packet == 16) work_by<16>(frame);
    else if (packet == 8) work_by<8>(frame);
    else work_by<1>(frame);
}

/// Numbers that are too small for the usual form count as 0: Embree asks for it.
void flush_small_numbers() {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
}

/// Threads that wait for frames and trace them beside the one that asks.
class Helpers {
  public:
    Helpers() {
        for (unsigned i = 1; i < THREADS; i++) threads.emplace_back([this] { work(); });
    }
    ~Helpers() {
        {
            std::lock_guard lock(mutex);
            ending = true;
        }
        wake.notify_all();
        for (std::thread &thread : threads) thread.join();
    }
    void trace(unsigned packet, Frame &frame) {
        {
            std::lock_guard lock(mutex);
            current = &frame;
            rays = packet;
            busy = static_cast<unsigned>(threads.size());
            number++;
        }
        wake.notify_all();
        trace_by(packet, frame);
        std::unique_lock lock(mutex);
        done.wait(lock, [this] { return busy == 0; });
    }

  private:
    void work() {
        flush_small_numbers();
        std::uint64_t seen = 0;
        for (;;) {
            std::unique_lock lock(mutex);
            wake.wait(lock, [&] { return ending || number != seen; });
            if (ending) return;
            seen = number;
            Frame &frame = *current;
            const unsigned packet = rays;
            lock.unlock();
            trace_by(packet, frame);
            lock.lock();
            if (--busy == 0) done.notify_one();
        }
    }

    std::mutex mutex;
    std::condition_variable wake, done;
    Frame *current = nullptr;
    unsigned rays = 0, busy = 0;
    std::uint64_t number = 0;
    bool ending = false;
    std::vector<std::thread> threads;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

} // namespace

int main(int count, char **arguments) {
    if (count != 2) fail("expected one argument, the scene");
    flush_small_numbers();
    const Scene scene = read(arguments[1]);
    RTCDevice device = rtcNewDevice(("threads=" + std::to_string(THREADS)).c_str());
    auto begin = std::chrono::steady_clock::now();
    RTCScene space = divide(device, scene, RTC_BUILD_QUALITY_HIGH);
    std::cout << "built " << seconds_since(begin) << std::endl;
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE) fail("space could not be divided");

    std::vector<float> picture(static_cast<std::size_t>(scene.header.columns) * scene.header.lines);
    {
        Helpers helpers;
        Texture texture;
        for (std::string line; std::getline(std::cin, line);) {
            std::istringstream words(line);
            std::string what, path;
            unsigned packet = 0;
            float sun[3] = {0.0f, 0.0f, 0.0f}, lift = 0.0f;
            words >> what >> packet;
            const bool whole = packet == 16 || packet == 8 || packet == 1;
            const bool by_sun = (what == "trace" || what == "light") && words >> sun[0] >> sun[1] >> sun[2];
            const bool of_vertices = what == "light" && by_sun && words >> lift && picture.size() == scene.vertices.size();
            const bool of_texture = what == "drape" && !texture.lights.empty();
            if (whole && (what == "show" || of_texture || (what == "trace" && by_sun) || of_vertices)) {
                const Work work = what == "show" ? Work::OwnLight : of_texture ? Work::Texture : what == "trace" ? Work::Sun : Work::Vertices;
                Frame frame{scene, space, {sun[0], sun[1], sun[2]}, work, lift, texture, picture};
                begin = std::chrono::steady_clock::now();
                helpers.trace(packet, frame);
                std::cout << seconds_since(begin) << std::endl;
            } else if (line == "divide low" || line == "divide medium" || line == "divide high") {
                rtcReleaseScene(space);
                begin = std::chrono::steady_clock::now();
                space = divide(device, scene,
                               line == "divide low"      ? RTC_BUILD_QUALITY_LOW
                               : line == "divide medium" ? RTC_BUILD_QUALITY_MEDIUM
                                                         : RTC_BUILD_QUALITY_HIGH);
                std::cout << seconds_since(begin) << std::endl;
            } else if (what == "texture") {
                std::istringstream whole_line(line);
                whole_line >> what >> texture.columns >> texture.lines >> path;
                texture.lights.resize(static_cast<std::size_t>(texture.columns) * texture.lines);
                std::ifstream file(path, std::ios::binary);
                if (!file.read(reinterpret_cast<char *>(texture.lights.data()), static_cast<std::streamsize>(texture.lights.size() * sizeof(float))))
                    fail(path + ": too short");
                std::cout << "read" << std::endl;
            } else if (line.rfind("picture ", 0) == 0) {
                path = line.substr(8);
                std::ofstream file(path, std::ios::binary);
                file.write(reinterpret_cast<const char *>(picture.data()),
                           static_cast<std::streamsize>(picture.size() * sizeof(float)));
                if (!file.flush()) fail(path + ": cannot be written");
                std::cout << "written" << std::endl;
            } else {
                fail("expected 'trace PACKET NORTH EAST UP', 'show PACKET', 'texture COLUMNS LINES PATH', 'drape PACKET' or 'light PACKET NORTH EAST UP LIFT' (a pixel for each vertex) with packets of 16, 8 or 1, 'divide low|medium|high' or 'picture PATH', found '" + line + "'");
            }
        }
    }
    rtcReleaseScene(space);
    rtcReleaseDevice(device);
}
