// SPDX-License-Identifier: MIT
#pragma once

// A glTF 2.0 file as plain data: standard C++ only, so that the parser needs no engine header and the engine no parser
// header.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace SceneFile {

/** Triangles of one material in glTF's space (metres, right-handed, Y up). Arrays are empty where the file has none. */
struct FPrimitive {
    std::vector<float> Positions;
    std::vector<float> Normals;
    std::vector<float> Tangents;
    std::vector<float> TexCoords0;
    std::vector<float> TexCoords1;
    /** RGBA, 0 to 1. */
    std::vector<float> Colors;
    std::vector<std::uint32_t> Indices;
    /** Index into FDocument::Materials, or -1 for the default material. */
    int Material = -1;
};

struct FMesh {
    std::string Name;
    std::vector<FPrimitive> Primitives;
};

/** A decoded image: RGBA8 rows from the top. */
struct FImage {
    std::string Name;
    int Width = 0;
    int Height = 0;
    std::vector<std::uint8_t> Pixels;
    /** As in the file, until they are decoded. */
    std::vector<std::uint8_t> Encoded;
};

enum class EWrap { Repeat, Clamp, Mirror };

struct FTexture {
    std::string Name;
    int Image = -1;
    EWrap WrapU = EWrap::Repeat;
    EWrap WrapV = EWrap::Repeat;
    bool bNearest = false;
};

enum class EAlpha { Opaque, Mask, Blend };

struct FMaterial {
    std::string Name;
    std::array<double, 4> BaseColor{1.0, 1.0, 1.0, 1.0};
    std::array<double, 3> Emissive{0.0, 0.0, 0.0};
    double Metallic = 1.0;
    double Roughness = 1.0;
    double Specular = 0.5;
    double NormalScale = 1.0;
    double OcclusionStrength = 1.0;
    double AlphaCutoff = 0.5;
    std::array<double, 2> UVScale{1.0, 1.0};
    std::array<double, 2> UVOffset{0.0, 0.0};
    int BaseColorTexture = -1;
    int MetallicRoughnessTexture = -1;
    int OcclusionTexture = -1;
    int NormalTexture = -1;
    int EmissiveTexture = -1;
    EAlpha Alpha = EAlpha::Opaque;
    bool bDoubleSided = false;
};

enum class ELight { Directional, Point, Spot };

/** KHR_lights_punctual: candela or lux, metres, radians. */
struct FLight {
    ELight Type = ELight::Point;
    std::array<double, 3> Color{1.0, 1.0, 1.0};
    double Intensity = 1.0;
    /** 0: unlimited. */
    double Range = 0.0;
    double InnerConeAngle = 0.0;
    double OuterConeAngle = 0.7853981633974483;
};

struct FNode {
    std::string Name;
    std::array<double, 3> Translation{0.0, 0.0, 0.0};
    /** x, y, z, w; of unit length. */
    std::array<double, 4> Rotation{0.0, 0.0, 0.0, 1.0};
    std::array<double, 3> Scale{1.0, 1.0, 1.0};
    int Mesh = -1;
    int Light = -1;
    int Camera = -1;
    int Parent = -1;
};

struct FCamera {
    bool bPerspective = true;
    /** Radians; 0 if the aspect ratio is not given. */
    double VerticalFieldOfView = 0.0;
    double AspectRatio = 0.0;
    double OrthographicWidth = 0.0;
};

struct FDocument {
    std::vector<FMesh> Meshes;
    std::vector<FImage> Images;
    std::vector<FTexture> Textures;
    std::vector<FMaterial> Materials;
    std::vector<FLight> Lights;
    std::vector<FCamera> Cameras;
    /** Nodes of the scene, each after its parent. */
    std::vector<FNode> Nodes;
};

/**
 * Reads a .gltf or .glb file completely: buffers are bounds-checked, images decoded (on several threads), indices
 * validated.
 *
 * @return false with a text in OutError naming the file and, where there is one, the mesh or node, and what was wrong.
 */
bool ReadGltf(const std::string& Path, FDocument& OutDocument, std::string& OutError);

} // namespace SceneFile
