// Searches meshes for what rays meet with Embree 3, on command; the twin of KernelServer.java,
// which tells commands and files. Rays are searched one by one, as Lumbre does. Options:
//   robust   build scenes with Embree's flag for rays that may not slip through edges
//
//   g++ -std=c++17 -O3 -march=native -o embree_server embree_server.cpp -lembree3

#include <embree3/rtcore.h>

#include <ctime>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr size_t floatsPerRay = 7;

template <typename T>
std::vector<T> read(const std::string &path) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::vector<T> values(static_cast<size_t>(file.tellg()) / sizeof(T));
  file.seekg(0);
  file.read(reinterpret_cast<char *>(values.data()), values.size() * sizeof(T));
  return values;
}

double cpuSeconds() {
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return time.tv_sec + 1e-9 * time.tv_nsec;
}

class Server {
 public:
  explicit Server(bool robust) : device(rtcNewDevice("threads=1,set_affinity=0")), robust(robust) {}

  long answer(const std::string &command, const std::string &argument) {
    if (command == "load") return load(argument);
    if (command == "rays") {
      rays = read<float>(argument);
      return rays.size() / floatsPerRay;
    }
    if (command == "closest") return repeat(argument, &Server::closest);
    if (command == "any") return repeat(argument, &Server::any);
    if (command == "hits") return writeHits(argument);
    throw std::runtime_error("no such command: " + command);
  }

 private:
  RTCDevice device;
  bool robust;
  RTCScene scene = nullptr;
  std::vector<float> rays;

  long load(const std::string &mesh) {
    if (scene) rtcReleaseScene(scene);
    const auto positions = read<float>(mesh + ".positions");
    const auto indices = read<uint32_t>(mesh + ".indices");
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    void *vertexBuffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), positions.size() / 3);
    void *indexBuffer =
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(uint32_t), indices.size() / 3);
    std::memcpy(vertexBuffer, positions.data(), positions.size() * sizeof(float));
    std::memcpy(indexBuffer, indices.data(), indices.size() * sizeof(uint32_t));
    rtcCommitGeometry(geometry);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return indices.size() / 3;
  }

  RTCRay ray(size_t at, float length) const {
    RTCRay ray;
    ray.org_x = rays[at];
    ray.org_y = rays[at + 1];
    ray.org_z = rays[at + 2];
    ray.tnear = 0;
    ray.dir_x = rays[at + 3];
    ray.dir_y = rays[at + 4];
    ray.dir_z = rays[at + 5];
    ray.time = 0;
    ray.tfar = length;
    ray.mask = ~0u;
    ray.id = 0;
    ray.flags = 0;
    return ray;
  }

  bool findNearest(size_t at, RTCIntersectContext &context, RTCRayHit &search) const {
    search.ray = ray(at, std::numeric_limits<float>::infinity());
    search.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    search.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene, &context, &search);
    return search.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }

  long closest() const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit search;
    long hits = 0;
    for (size_t at = 0; at < rays.size(); at += floatsPerRay) {
      hits += findNearest(at, context, search);
    }
    return hits;
  }

  long any() const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    long hits = 0;
    for (size_t at = 0; at < rays.size(); at += floatsPerRay) {
      RTCRay search = ray(at, rays[at + 6]);
      rtcOccluded1(scene, &context, &search);
      hits += search.tfar < 0;
    }
    return hits;
  }

  long repeat(const std::string &times, long (Server::*search)() const) const {
    long hits = 0;
    for (int i = std::stoi(times); i > 0; i--) hits = (this->*search)();
    return hits;
  }

  long writeHits(const std::string &path) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit search;
    std::vector<float> found;
    for (size_t at = 0; at < rays.size(); at += floatsPerRay) {
      if (findNearest(at, context, search)) {
        const RTCHit &hit = search.hit;
        const float length = std::hypot(hit.Ng_x, hit.Ng_y, hit.Ng_z);
        found.insert(found.end(), {search.ray.tfar, hit.Ng_x / length, hit.Ng_y / length,
                                   hit.Ng_z / length});
      } else {
        found.insert(found.end(), {std::numeric_limits<float>::infinity(), 0, 0, 0});
      }
    }
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char *>(found.data()), found.size() * sizeof(float));
    return found.size() / 4;
  }
};

}  // namespace

int main(int argc, char **argv) {
  Server server(argc > 1 && std::string(argv[1]) == "robust");
  std::string command, argument;
  while (std::cin >> command >> argument) {
    const double cpu = cpuSeconds();
    const auto start = std::chrono::steady_clock::now();
    const long hits = server.answer(command, argument);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("{\"cpu\": %.6f, \"seconds\": %.6f, \"hits\": %ld}\n", cpuSeconds() - cpu,
                seconds.count(), hits);
    std::fflush(stdout);
  }
}
