// SPDX-License-Identifier: MIT
// Compiled with exceptions and without any engine header: tinygltf and nlohmann-json need both.

#include "GltfFile.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <thread>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wundef"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace SceneFile {
namespace {

/** A fault of the file; its text becomes the error after the file's name. */
struct FFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

[[noreturn]] void Fail(const std::string& Text) { throw FFault(Text); }

std::string Quoted(const std::string& Kind, const std::string& Name, std::size_t Index) {
    return Kind + " " + (Name.empty() ? "#" + std::to_string(Index) : "'" + Name + "'");
}

const std::array<const char*, 7> SupportedExtensions = {
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_materials_specular",
    "KHR_materials_ior",
    "KHR_materials_unlit",
};

double Number(const tinygltf::Value& Object, const char* Key, double Default) {
    if (!Object.IsObject() || !Object.Has(Key)) {
        return Default;
    }
    const tinygltf::Value& Value = Object.Get(Key);
    return Value.IsNumber() ? Value.GetNumberAsDouble() : Default;
}

/** Reads an accessor of N components as doubles scaled to the values they mean. */
class FAccessorReader {
public:
    FAccessorReader(const tinygltf::Model& InModel, int InIndex, const std::string& InWhere) : Where(InWhere) {
        if (InIndex < 0 || static_cast<std::size_t>(InIndex) >= InModel.accessors.size()) {
            Fail(Where + " refers to accessor " + std::to_string(InIndex) + ", but the file has " +
                 std::to_string(InModel.accessors.size()));
        }
        Accessor = &InModel.accessors[static_cast<std::size_t>(InIndex)];
        if (Accessor->sparse.isSparse) {
            Fail(Where + " uses a sparse accessor, which is not supported: export it dense");
        }
        if (Accessor->bufferView < 0 || static_cast<std::size_t>(Accessor->bufferView) >= InModel.bufferViews.size()) {
            Fail(Where + " has no buffer view");
        }
        const tinygltf::BufferView& View = InModel.bufferViews[static_cast<std::size_t>(Accessor->bufferView)];
        if (View.buffer < 0 || static_cast<std::size_t>(View.buffer) >= InModel.buffers.size()) {
            Fail(Where + " refers to buffer " + std::to_string(View.buffer) + ", which does not exist");
        }
        const tinygltf::Buffer& Buffer = InModel.buffers[static_cast<std::size_t>(View.buffer)];
        const int ComponentSize =
            tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(Accessor->componentType));
        Components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(Accessor->type));
        if (ComponentSize <= 0 || Components <= 0 || Components > 4) {
            Fail(Where + " has a component type or an element type that does not belong there");
        }
        const std::size_t ElementSize = static_cast<std::size_t>(ComponentSize) * static_cast<std::size_t>(Components);
        Stride = View.byteStride != 0 ? View.byteStride : ElementSize;
        const std::size_t ViewEnd = View.byteOffset + View.byteLength;
        const std::size_t Start = View.byteOffset + Accessor->byteOffset;
        if (View.byteOffset > Buffer.data.size() || View.byteLength > Buffer.data.size() - View.byteOffset ||
            Stride < ElementSize || Accessor->byteOffset > View.byteLength ||
            (Accessor->count > 0 &&
                (ElementSize > ViewEnd - Start || Accessor->count - 1 > (ViewEnd - Start - ElementSize) / Stride))) {
            Fail(Where + " reads beyond the end of its buffer (" + std::to_string(Accessor->count) + " elements of " +
                 std::to_string(ElementSize) + " bytes, the buffer has " + std::to_string(Buffer.data.size()) + ")");
        }
        Bytes = Buffer.data.data() + Start;
    }

    std::size_t Count() const { return Accessor->count; }

    int NumComponents() const { return Components; }

    double Value(std::size_t Element, int Component, bool bForceNormalized) const {
        const unsigned char* Place = Bytes + Element * Stride;
        const bool bScale = Accessor->normalized || bForceNormalized;
        switch (Accessor->componentType) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return Load<float>(Place, Component);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return Load<std::uint8_t>(Place, Component) / (bScale ? 255.0 : 1.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return Load<std::uint16_t>(Place, Component) / (bScale ? 65535.0 : 1.0);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return Load<std::uint32_t>(Place, Component);
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return bScale ? std::max(Load<std::int8_t>(Place, Component) / 127.0, -1.0)
                          : Load<std::int8_t>(Place, Component);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return bScale ? std::max(Load<std::int16_t>(Place, Component) / 32767.0, -1.0)
                          : Load<std::int16_t>(Place, Component);
        default:
            Fail(Where + " has component type " + std::to_string(Accessor->componentType) +
                 ", which does not belong there");
        }
    }

private:
    template <typename T>
    static T Load(const unsigned char* Place, int Component) {
        T Result;
        std::memcpy(&Result, Place + static_cast<std::size_t>(Component) * sizeof(T), sizeof(T));
        return Result;
    }

    std::string Where;
    const tinygltf::Accessor* Accessor = nullptr;
    const unsigned char* Bytes = nullptr;
    std::size_t Stride = 0;
    int Components = 0;
};

std::vector<float> ReadVectors(const tinygltf::Model& Model, int Accessor, int Components, std::size_t ExpectedCount,
    const std::string& Where, bool bForceNormalized = false) {
    const FAccessorReader Reader(Model, Accessor, Where);
    if (Reader.NumComponents() != Components) {
        Fail(Where + " has " + std::to_string(Reader.NumComponents()) + " components, expected " +
             std::to_string(Components));
    }
    if (ExpectedCount != 0 && Reader.Count() != ExpectedCount) {
        Fail(Where + " has " + std::to_string(Reader.Count()) + " elements, but there are " +
             std::to_string(ExpectedCount) + " positions");
    }
    std::vector<float> Result;
    Result.reserve(Reader.Count() * static_cast<std::size_t>(Components));
    for (std::size_t Element = 0; Element < Reader.Count(); ++Element) {
        for (int Component = 0; Component < Components; ++Component) {
            const float Value = static_cast<float>(Reader.Value(Element, Component, bForceNormalized));
            if (!std::isfinite(Value)) {
                Fail(Where + " holds a value that is not finite at element " + std::to_string(Element));
            }
            Result.push_back(Value);
        }
    }
    return Result;
}

/** Turns strips and fans into plain triangles. */
std::vector<std::uint32_t> Triangles(std::vector<std::uint32_t> Source, int Mode, const std::string& Where) {
    if (Mode == TINYGLTF_MODE_TRIANGLES || Mode == -1) {
        if (Source.size() % 3 != 0) {
            Fail(Where + " has " + std::to_string(Source.size()) + " indices, which is not a multiple of 3");
        }
        return Source;
    }
    if (Mode != TINYGLTF_MODE_TRIANGLE_STRIP && Mode != TINYGLTF_MODE_TRIANGLE_FAN) {
        Fail(Where + " is made of points or lines; only triangles are supported");
    }
    std::vector<std::uint32_t> Result;
    for (std::size_t Index = 2; Index < Source.size(); ++Index) {
        if (Mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            Result.insert(Result.end(), {Source[0], Source[Index - 1], Source[Index]});
        } else if (Index % 2 == 0) {
            Result.insert(Result.end(), {Source[Index - 2], Source[Index - 1], Source[Index]});
        } else {
            Result.insert(Result.end(), {Source[Index - 1], Source[Index - 2], Source[Index]});
        }
    }
    return Result;
}

FPrimitive ReadPrimitive(const tinygltf::Model& Model, const tinygltf::Primitive& Source, const std::string& Where) {
    FPrimitive Result;
    const auto Attribute = [&Source](const char* Name) {
        const auto Found = Source.attributes.find(Name);
        return Found == Source.attributes.end() ? -1 : Found->second;
    };
    if (Attribute("POSITION") < 0) {
        Fail(Where + " has no POSITION attribute");
    }
    Result.Positions = ReadVectors(Model, Attribute("POSITION"), 3, 0, Where + " POSITION");
    const std::size_t Count = Result.Positions.size() / 3;
    if (Attribute("NORMAL") >= 0) {
        Result.Normals = ReadVectors(Model, Attribute("NORMAL"), 3, Count, Where + " NORMAL");
    }
    if (Attribute("TANGENT") >= 0) {
        Result.Tangents = ReadVectors(Model, Attribute("TANGENT"), 4, Count, Where + " TANGENT");
    }
    if (Attribute("TEXCOORD_0") >= 0) {
        Result.TexCoords0 = ReadVectors(Model, Attribute("TEXCOORD_0"), 2, Count, Where + " TEXCOORD_0");
    }
    if (Attribute("TEXCOORD_1") >= 0) {
        Result.TexCoords1 = ReadVectors(Model, Attribute("TEXCOORD_1"), 2, Count, Where + " TEXCOORD_1");
    }
    if (Attribute("COLOR_0") >= 0) {
        const int Components = FAccessorReader(Model, Attribute("COLOR_0"), Where + " COLOR_0").NumComponents();
        std::vector<float> Colors =
            ReadVectors(Model, Attribute("COLOR_0"), Components, Count, Where + " COLOR_0", true);
        if (Components == 3) {
            for (std::size_t Index = 0; Index < Count; ++Index) {
                Result.Colors.insert(
                    Result.Colors.end(), {Colors[3 * Index], Colors[3 * Index + 1], Colors[3 * Index + 2], 1.0f});
            }
        } else {
            Result.Colors = std::move(Colors);
        }
    }
    std::vector<std::uint32_t> Indices;
    if (Source.indices >= 0) {
        const FAccessorReader Reader(Model, Source.indices, Where + " indices");
        if (Reader.NumComponents() != 1) {
            Fail(Where + " indices are not scalars");
        }
        Indices.reserve(Reader.Count());
        for (std::size_t Element = 0; Element < Reader.Count(); ++Element) {
            const double Value = Reader.Value(Element, 0, false);
            if (!(Value >= 0.0 && Value < static_cast<double>(Count))) {
                Fail(Where + " has vertex index " + std::to_string(static_cast<long long>(Value)) + ", but only " +
                     std::to_string(Count) + " vertices");
            }
            Indices.push_back(static_cast<std::uint32_t>(Value));
        }
    } else {
        for (std::size_t Index = 0; Index < Count; ++Index) {
            Indices.push_back(static_cast<std::uint32_t>(Index));
        }
    }
    Result.Indices = Triangles(std::move(Indices), Source.mode, Where);
    if (Source.material >= static_cast<int>(Model.materials.size())) {
        Fail(Where + " refers to material " + std::to_string(Source.material) + ", which does not exist");
    }
    Result.Material = Source.material;
    return Result;
}

int TextureIndex(const tinygltf::Model& Model, int Index, const std::string& Where) {
    if (Index >= static_cast<int>(Model.textures.size())) {
        Fail(Where + " refers to texture " + std::to_string(Index) + ", which does not exist");
    }
    return Index < 0 ? -1 : Index;
}

FMaterial ReadMaterial(const tinygltf::Model& Model, const tinygltf::Material& Source, const std::string& Where) {
    FMaterial Result;
    Result.Name = Source.name;
    const tinygltf::PbrMetallicRoughness& Pbr = Source.pbrMetallicRoughness;
    for (std::size_t Index = 0; Index < 4 && Index < Pbr.baseColorFactor.size(); ++Index) {
        Result.BaseColor[Index] = Pbr.baseColorFactor[Index];
    }
    for (std::size_t Index = 0; Index < 3 && Index < Source.emissiveFactor.size(); ++Index) {
        Result.Emissive[Index] = Source.emissiveFactor[Index];
    }
    Result.Metallic = Pbr.metallicFactor;
    Result.Roughness = Pbr.roughnessFactor;
    Result.NormalScale = Source.normalTexture.scale;
    Result.OcclusionStrength = Source.occlusionTexture.strength;
    Result.AlphaCutoff = Source.alphaCutoff;
    Result.bDoubleSided = Source.doubleSided;
    Result.Alpha = Source.alphaMode == "BLEND"  ? EAlpha::Blend
                   : Source.alphaMode == "MASK" ? EAlpha::Mask
                                                : EAlpha::Opaque;
    Result.BaseColorTexture = TextureIndex(Model, Pbr.baseColorTexture.index, Where);
    Result.MetallicRoughnessTexture = TextureIndex(Model, Pbr.metallicRoughnessTexture.index, Where);
    Result.OcclusionTexture = TextureIndex(Model, Source.occlusionTexture.index, Where);
    Result.NormalTexture = TextureIndex(Model, Source.normalTexture.index, Where);
    Result.EmissiveTexture = TextureIndex(Model, Source.emissiveTexture.index, Where);
    const auto Extension = [](const tinygltf::ExtensionMap& Map, const char* Name) {
        const auto Found = Map.find(Name);
        return Found == Map.end() ? tinygltf::Value() : Found->second;
    };
    const double Strength =
        Number(Extension(Source.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    for (double& Channel : Result.Emissive) {
        Channel *= Strength;
    }
    const double Ior = Number(Extension(Source.extensions, "KHR_materials_ior"), "ior", 1.5);
    const double Reflectance = (Ior - 1.0) / (Ior + 1.0) * ((Ior - 1.0) / (Ior + 1.0));
    // UE's Specular 0.5 is a reflectance of 0.04.
    Result.Specular = std::clamp(Reflectance / 0.08, 0.0, 1.0) *
                      Number(Extension(Source.extensions, "KHR_materials_specular"), "specularFactor", 1.0);
    const tinygltf::Value Transform = Extension(Pbr.baseColorTexture.extensions, "KHR_texture_transform");
    for (const char* Key : {"scale", "offset"}) {
        if (Transform.IsObject() && Transform.Has(Key) && Transform.Get(Key).IsArray() &&
            Transform.Get(Key).ArrayLen() == 2) {
            auto& Target = std::strcmp(Key, "scale") == 0 ? Result.UVScale : Result.UVOffset;
            for (int Index = 0; Index < 2; ++Index) {
                Target[static_cast<std::size_t>(Index)] = Transform.Get(Key).Get(Index).GetNumberAsDouble();
            }
        }
    }
    return Result;
}

FLight ReadLight(const tinygltf::Light& Source, const std::string& Where) {
    FLight Result;
    if (Source.type == "directional") {
        Result.Type = ELight::Directional;
    } else if (Source.type == "spot") {
        Result.Type = ELight::Spot;
    } else if (Source.type != "point") {
        Fail(Where + " has type '" + Source.type + "'; expected directional, point or spot");
    }
    for (std::size_t Index = 0; Index < 3 && Index < Source.color.size(); ++Index) {
        Result.Color[Index] = Source.color[Index];
    }
    Result.Intensity = Source.intensity;
    Result.Range = std::max(Source.range, 0.0);
    if (Result.Type == ELight::Spot) {
        Result.InnerConeAngle = Source.spot.innerConeAngle;
        Result.OuterConeAngle = Source.spot.outerConeAngle;
    }
    return Result;
}

/** Splits a column-major matrix into translation, rotation and scale; refuses shear. */
void Decompose(const std::vector<double>& M, FNode& Node, const std::string& Where) {
    Node.Translation = {M[12], M[13], M[14]};
    std::array<std::array<double, 3>, 3> Axis{};
    for (std::size_t Column = 0; Column < 3; ++Column) {
        for (std::size_t Row = 0; Row < 3; ++Row) {
            Axis[Column][Row] = M[4 * Column + Row];
        }
        Node.Scale[Column] = std::hypot(Axis[Column][0], Axis[Column][1], Axis[Column][2]);
        if (Node.Scale[Column] < 1e-12) {
            Fail(Where + " has a matrix that flattens an axis; give translation, rotation and scale");
        }
        for (double& Value : Axis[Column]) {
            Value /= Node.Scale[Column];
        }
    }
    const auto Dot = [&Axis](std::size_t A, std::size_t B) {
        return Axis[A][0] * Axis[B][0] + Axis[A][1] * Axis[B][1] + Axis[A][2] * Axis[B][2];
    };
    if (std::abs(Dot(0, 1)) > 1e-4 || std::abs(Dot(0, 2)) > 1e-4 || std::abs(Dot(1, 2)) > 1e-4) {
        Fail(Where + " has a sheared matrix, which an actor's transform cannot express");
    }
    const double Determinant = Axis[0][0] * (Axis[1][1] * Axis[2][2] - Axis[1][2] * Axis[2][1]) -
                               Axis[1][0] * (Axis[0][1] * Axis[2][2] - Axis[0][2] * Axis[2][1]) +
                               Axis[2][0] * (Axis[0][1] * Axis[1][2] - Axis[0][2] * Axis[1][1]);
    if (Determinant < 0.0) {
        Node.Scale[0] = -Node.Scale[0];
        for (double& Value : Axis[0]) {
            Value = -Value;
        }
    }
    const double R00 = Axis[0][0], R11 = Axis[1][1], R22 = Axis[2][2];
    const double W = std::sqrt(std::max(0.0, 1.0 + R00 + R11 + R22)) / 2.0;
    const double X = std::copysign(std::sqrt(std::max(0.0, 1.0 + R00 - R11 - R22)) / 2.0, Axis[1][2] - Axis[2][1]);
    const double Y = std::copysign(std::sqrt(std::max(0.0, 1.0 - R00 + R11 - R22)) / 2.0, Axis[2][0] - Axis[0][2]);
    const double Z = std::copysign(std::sqrt(std::max(0.0, 1.0 - R00 - R11 + R22)) / 2.0, Axis[0][1] - Axis[1][0]);
    Node.Rotation = {X, Y, Z, W};
}

FNode ReadNode(const tinygltf::Model& Model, const tinygltf::Node& Source, const std::string& Where) {
    FNode Result;
    Result.Name = Source.name;
    if (Source.matrix.size() == 16) {
        Decompose(Source.matrix, Result, Where);
    }
    if (Source.translation.size() == 3) {
        std::copy_n(Source.translation.begin(), 3, Result.Translation.begin());
    }
    if (Source.rotation.size() == 4) {
        std::copy_n(Source.rotation.begin(), 4, Result.Rotation.begin());
    }
    if (Source.scale.size() == 3) {
        std::copy_n(Source.scale.begin(), 3, Result.Scale.begin());
    }
    double Length = 0.0;
    for (const double Value : Result.Rotation) {
        Length += Value * Value;
    }
    Length = std::sqrt(Length);
    for (const double Value : {Result.Translation[0], Result.Translation[1], Result.Translation[2], Result.Scale[0],
             Result.Scale[1], Result.Scale[2], Length}) {
        if (!std::isfinite(Value)) {
            Fail(Where + " has a transform that is not finite");
        }
    }
    if (Length < 1e-6) {
        Fail(Where + " has a rotation of length 0");
    }
    for (double& Value : Result.Rotation) {
        Value /= Length;
    }
    const auto Check = [&Where](int Index, std::size_t Size, const char* Kind) {
        if (Index >= static_cast<int>(Size)) {
            Fail(Where + " refers to " + Kind + " " + std::to_string(Index) + ", but the file has " +
                 std::to_string(Size));
        }
        return Index < 0 ? -1 : Index;
    };
    Result.Mesh = Check(Source.mesh, Model.meshes.size(), "mesh");
    Result.Camera = Check(Source.camera, Model.cameras.size(), "camera");
    const auto Punctual = Source.extensions.find("KHR_lights_punctual");
    if (Punctual != Source.extensions.end()) {
        const double Light = Number(Punctual->second, "light", -1.0);
        Result.Light = Check(static_cast<int>(std::clamp(Light, -1.0, 1e9)), Model.lights.size(), "light");
    }
    return Result;
}

void ReadNodes(const tinygltf::Model& Model, FDocument& Document) {
    if (Model.scenes.empty()) {
        Fail("there is no scene in it");
    }
    const int Default = Model.defaultScene < 0 ? 0 : Model.defaultScene;
    if (Default >= static_cast<int>(Model.scenes.size())) {
        Fail("the default scene " + std::to_string(Default) + " does not exist");
    }
    std::vector<bool> Seen(Model.nodes.size(), false);
    struct FVisit {
        int Node;
        int Parent;
    };
    std::vector<FVisit> Stack;
    const auto Push = [&Stack](const std::vector<int>& Children, int Parent) {
        for (auto Child = Children.rbegin(); Child != Children.rend(); ++Child) {
            Stack.push_back({*Child, Parent});
        }
    };
    Push(Model.scenes[static_cast<std::size_t>(Default)].nodes, -1);
    while (!Stack.empty()) {
        const FVisit Visit = Stack.back();
        Stack.pop_back();
        if (Visit.Node < 0 || static_cast<std::size_t>(Visit.Node) >= Model.nodes.size()) {
            Fail("the scene refers to node " + std::to_string(Visit.Node) + ", but the file has " +
                 std::to_string(Model.nodes.size()));
        }
        const auto Index = static_cast<std::size_t>(Visit.Node);
        const tinygltf::Node& Source = Model.nodes[Index];
        const std::string Where = Quoted("node", Source.name, Index);
        if (Seen[Index]) {
            Fail(Where + " has two parents or is its own ancestor");
        }
        Seen[Index] = true;
        FNode Node = ReadNode(Model, Source, Where);
        Node.Parent = Visit.Parent;
        Document.Nodes.push_back(std::move(Node));
        Push(Source.children, static_cast<int>(Document.Nodes.size()) - 1);
    }
}

/** Decodes all images; each thread takes the next one. */
void DecodeImages(std::vector<FImage>& Images) {
    std::atomic<std::size_t> Next{0};
    std::vector<std::string> Errors(Images.size());
    const auto Work = [&Images, &Next, &Errors] {
        for (std::size_t Index = Next++; Index < Images.size(); Index = Next++) {
            FImage& Image = Images[Index];
            int Channels = 0;
            stbi_uc* Pixels = stbi_load_from_memory(Image.Encoded.data(), static_cast<int>(Image.Encoded.size()),
                &Image.Width, &Image.Height, &Channels, 4);
            if (Pixels == nullptr) {
                const char* Reason = stbi_failure_reason();
                Errors[Index] = Quoted("image", Image.Name, Index) + " is not a PNG or JPEG image that can be read (" +
                                (Reason != nullptr ? Reason : "unknown") + ")";
                continue;
            }
            Image.Pixels.assign(
                Pixels, Pixels + static_cast<std::size_t>(Image.Width) * static_cast<std::size_t>(Image.Height) * 4);
            stbi_image_free(Pixels);
            Image.Encoded = {};
        }
    };
    std::vector<std::thread> Threads;
    const unsigned Count = std::clamp(std::thread::hardware_concurrency(), 1u, 8u);
    for (unsigned Index = 1; Index < Count && Index < Images.size(); ++Index) {
        Threads.emplace_back(Work);
    }
    Work();
    for (std::thread& Thread : Threads) {
        Thread.join();
    }
    for (const std::string& Error : Errors) {
        if (!Error.empty()) {
            Fail(Error);
        }
    }
}

EWrap Wrap(int Mode) {
    return Mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE     ? EWrap::Clamp
           : Mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? EWrap::Mirror
                                                           : EWrap::Repeat;
}

/** tinygltf's callback: keeps the bytes, DecodeImages decodes them later. */
bool KeepEncoded(tinygltf::Image* Image, const int, std::string*, std::string*, int, int, const unsigned char* Bytes,
    int Size, void*) {
    Image->image.assign(Bytes, Bytes + Size);
    Image->width = Image->height = 1;
    Image->component = 4;
    Image->bits = 8;
    Image->pixel_type = TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    return true;
}

/** tinygltf walks nested values by recursion: this bounds its stack. */
constexpr int MaxNesting = 200;

void CheckNesting(const char* Text, std::size_t Size) {
    int Depth = 0;
    bool bString = false;
    for (std::size_t Index = 0; Index < Size; ++Index) {
        const char Character = Text[Index];
        if (bString) {
            Index += Character == '\\' ? 1 : 0;
            bString = Character != '"';
        } else if (Character == '"') {
            bString = true;
        } else if (Character == '[' || Character == '{') {
            if (++Depth > MaxNesting) {
                Fail("its JSON is nested more than " + std::to_string(MaxNesting) + " levels deep");
            }
        } else if (Character == ']' || Character == '}') {
            --Depth;
        }
    }
}

std::vector<char> ReadFile(const std::string& Path) {
    std::ifstream Stream(Path, std::ios::binary | std::ios::ate);
    const std::streamoff Size = Stream ? static_cast<std::streamoff>(Stream.tellg()) : -1;
    if (Size < 0 || Size > std::numeric_limits<std::int32_t>::max()) {
        Fail(Size < 0 ? "the file cannot be opened" : "the file is larger than 2 GB");
    }
    std::vector<char> Bytes(static_cast<std::size_t>(Size));
    Stream.seekg(0);
    if (!Stream.read(Bytes.data(), Size)) {
        Fail("the file cannot be read");
    }
    return Bytes;
}

void Parse(const std::string& Path, tinygltf::Model& Model) {
    tinygltf::TinyGLTF Loader;
    Loader.SetImageLoader(&KeepEncoded, nullptr);
    std::string Error;
    std::string Warning;
    const std::vector<char> Bytes = ReadFile(Path);
    const std::size_t Slash = Path.find_last_of('/');
    const std::string Folder = Slash == std::string::npos ? "." : Path.substr(0, Slash);
    const auto Size = static_cast<unsigned int>(Bytes.size());
    bool bRead = false;
    if (Path.size() > 4 && Path.compare(Path.size() - 4, 4, ".glb") == 0) {
        // Header of 12 bytes, then the length and kind of the JSON chunk (glTF 2.0, section 4.4).
        constexpr std::size_t JsonStart = 20;
        std::uint32_t JsonSize = 0;
        if (Bytes.size() > JsonStart) {
            std::memcpy(&JsonSize, &Bytes[12], sizeof(JsonSize));
            CheckNesting(&Bytes[JsonStart], std::min<std::size_t>(JsonSize, Bytes.size() - JsonStart));
        }
        bRead = Loader.LoadBinaryFromMemory(
            &Model, &Error, &Warning, reinterpret_cast<const unsigned char*>(Bytes.data()), Size, Folder);
    } else {
        CheckNesting(Bytes.data(), Bytes.size());
        bRead = Loader.LoadASCIIFromString(&Model, &Error, &Warning, Bytes.data(), Size, Folder);
    }
    if (!bRead || !Error.empty()) {
        while (!Error.empty() && (Error.back() == '\n' || Error.back() == ' ')) {
            Error.pop_back();
        }
        std::replace(Error.begin(), Error.end(), '\n', ';');
        Fail(Error.empty() ? "it is not a glTF 2.0 file" : Error);
    }
    if (Model.asset.version.rfind("2.", 0) != 0) {
        Fail("its version is '" + Model.asset.version + "', expected 2.0");
    }
    for (const std::string& Extension : Model.extensionsRequired) {
        if (std::find(SupportedExtensions.begin(), SupportedExtensions.end(), Extension) == SupportedExtensions.end()) {
            Fail("it requires the extension " + Extension + ", which is not supported: export without it");
        }
    }
}

void Convert(tinygltf::Model& Model, FDocument& Document) {
    for (std::size_t Index = 0; Index < Model.images.size(); ++Index) {
        FImage Image;
        Image.Name = Model.images[Index].name.empty() ? Model.images[Index].uri : Model.images[Index].name;
        Image.Encoded = std::move(Model.images[Index].image);
        if (Image.Encoded.empty()) {
            Fail(Quoted("image", Image.Name, Index) + " has no data; is its file missing?");
        }
        Document.Images.push_back(std::move(Image));
    }
    DecodeImages(Document.Images);
    for (std::size_t Index = 0; Index < Model.textures.size(); ++Index) {
        const tinygltf::Texture& Source = Model.textures[Index];
        FTexture Texture;
        Texture.Name = Source.name;
        if (Source.source < 0 || static_cast<std::size_t>(Source.source) >= Document.Images.size()) {
            Fail(Quoted("texture", Source.name, Index) + " refers to image " + std::to_string(Source.source) +
                 ", which does not exist");
        }
        Texture.Image = Source.source;
        if (Source.sampler >= 0) {
            if (static_cast<std::size_t>(Source.sampler) >= Model.samplers.size()) {
                Fail(Quoted("texture", Source.name, Index) + " refers to sampler " + std::to_string(Source.sampler) +
                     ", which does not exist");
            }
            const tinygltf::Sampler& Sampler = Model.samplers[static_cast<std::size_t>(Source.sampler)];
            Texture.WrapU = Wrap(Sampler.wrapS);
            Texture.WrapV = Wrap(Sampler.wrapT);
            Texture.bNearest = Sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        }
        Document.Textures.push_back(std::move(Texture));
    }
    for (std::size_t Index = 0; Index < Model.materials.size(); ++Index) {
        Document.Materials.push_back(
            ReadMaterial(Model, Model.materials[Index], Quoted("material", Model.materials[Index].name, Index)));
    }
    for (std::size_t Index = 0; Index < Model.meshes.size(); ++Index) {
        const tinygltf::Mesh& Source = Model.meshes[Index];
        FMesh Mesh;
        Mesh.Name = Source.name;
        for (std::size_t Primitive = 0; Primitive < Source.primitives.size(); ++Primitive) {
            Mesh.Primitives.push_back(ReadPrimitive(Model, Source.primitives[Primitive],
                Quoted("mesh", Source.name, Index) + " primitive " + std::to_string(Primitive)));
        }
        Document.Meshes.push_back(std::move(Mesh));
    }
    for (std::size_t Index = 0; Index < Model.lights.size(); ++Index) {
        Document.Lights.push_back(ReadLight(Model.lights[Index], Quoted("light", Model.lights[Index].name, Index)));
    }
    for (const tinygltf::Camera& Source : Model.cameras) {
        FCamera Camera;
        Camera.bPerspective = Source.type != "orthographic";
        Camera.VerticalFieldOfView = Source.perspective.yfov;
        Camera.AspectRatio = Source.perspective.aspectRatio;
        Camera.OrthographicWidth = 2.0 * Source.orthographic.xmag;
        Document.Cameras.push_back(Camera);
    }
    ReadNodes(Model, Document);
}

} // namespace

bool ReadGltf(const std::string& Path, FDocument& OutDocument, std::string& OutError) {
    try {
        tinygltf::Model Model;
        Parse(Path, Model);
        FDocument Document;
        Convert(Model, Document);
        OutDocument = std::move(Document);
        return true;
    } catch (const std::exception& Exception) {
        OutError = Path + ": " + Exception.what();
        return false;
    }
}

} // namespace SceneFile
