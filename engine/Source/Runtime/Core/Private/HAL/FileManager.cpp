// SPDX-License-Identifier: MIT
// IFileManager over std::filesystem, and FFileHelper over it.
#include "HAL/FileManager.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "CoreMinimal.h"
#include "Misc/FileHelper.h"

namespace {
namespace Files = std::filesystem;

Files::path ToPath(const TCHAR* Name) { return Files::path(std::string(TCHAR_TO_UTF8(Name))); }
FString FromPath(const Files::path& Path) { return FString(UTF8_TO_TCHAR(Path.c_str())); }

/** Whether a name fits a pattern with * and ?. */
bool FitsPattern(const FString& Name, const FString& Pattern) {
    return Pattern.IsEmpty() || Pattern == TEXT("*") || Pattern == TEXT("*.*") || Name.MatchesWildcard(Pattern);
}

class FFileManagerPosix final : public IFileManager {
public:
    virtual bool FileExists(const TCHAR* Filename) override {
        std::error_code Error;
        return Files::is_regular_file(ToPath(Filename), Error);
    }
    virtual bool DirectoryExists(const TCHAR* InDirectory) override {
        std::error_code Error;
        return Files::is_directory(ToPath(InDirectory), Error);
    }
    virtual int64 FileSize(const TCHAR* Filename) override {
        std::error_code Error;
        const auto Size = Files::file_size(ToPath(Filename), Error);
        return Error ? INDEX_NONE : static_cast<int64>(Size);
    }
    virtual bool Delete(const TCHAR* Filename, bool RequireExists, bool EvenReadOnly, bool Quiet) override {
        std::error_code Error;
        const bool bRemoved = Files::remove(ToPath(Filename), Error);
        return !Error && (bRemoved || !RequireExists);
    }
    virtual bool Move(const TCHAR* Dest, const TCHAR* Src, bool bReplace) override {
        std::error_code Error;
        if (!bReplace && Files::exists(ToPath(Dest), Error)) {
            return false;
        }
        Files::rename(ToPath(Src), ToPath(Dest), Error);
        return !Error;
    }
    virtual uint32 Copy(const TCHAR* Dest, const TCHAR* Src, bool bReplace) override {
        std::error_code Error;
        const auto Options = bReplace ? Files::copy_options::overwrite_existing : Files::copy_options::none;
        return Files::copy_file(ToPath(Src), ToPath(Dest), Options, Error) && !Error ? 0 : 1;
    }
    virtual bool MakeDirectory(const TCHAR* Path, bool Tree) override {
        std::error_code Error;
        Tree ? Files::create_directories(ToPath(Path), Error) : Files::create_directory(ToPath(Path), Error);
        return !Error && Files::is_directory(ToPath(Path), Error);
    }
    virtual bool DeleteDirectory(const TCHAR* Path, bool RequireExists, bool Tree) override {
        std::error_code Error;
        if (!Files::is_directory(ToPath(Path), Error)) {
            return !RequireExists;
        }
        Tree ? (void)Files::remove_all(ToPath(Path), Error) : (void)Files::remove(ToPath(Path), Error);
        return !Error;
    }
    virtual void FindFiles(TArray<FString>& FileNames, const TCHAR* Filename, bool bFiles, bool bDirectories) override {
        const Files::path Path = ToPath(Filename);
        std::error_code Error;
        const bool bWholeDirectory = Files::is_directory(Path, Error);
        const FString Pattern = bWholeDirectory ? FString() : FromPath(Path.filename());
        for (Files::directory_iterator At(bWholeDirectory ? Path : Path.parent_path(), Error), End; !Error && At != End;
            At.increment(Error)) {
            const FString Name = FromPath(At->path().filename());
            std::error_code Ignored;
            if ((At->is_directory(Ignored) ? bDirectories : bFiles) && FitsPattern(Name, Pattern)) {
                FileNames.Add(Name);
            }
        }
        FileNames.Sort();
    }
    virtual void FindFilesRecursive(TArray<FString>& FileNames, const TCHAR* StartDirectory, const TCHAR* Filename,
        bool bFiles, bool bDirectories, bool bClearFileNames) override {
        if (bClearFileNames) {
            FileNames.Empty();
        }
        std::error_code Error;
        const FString Pattern(Filename);
        for (Files::recursive_directory_iterator
                 At(ToPath(StartDirectory), Files::directory_options::skip_permission_denied, Error),
            End;
            !Error && At != End; At.increment(Error)) {
            std::error_code Ignored;
            if ((At->is_directory(Ignored) ? bDirectories : bFiles) &&
                FitsPattern(FromPath(At->path().filename()), Pattern)) {
                FileNames.Add(FromPath(At->path()));
            }
        }
        FileNames.Sort();
    }
    virtual FDateTime GetTimeStamp(const TCHAR* Path) override {
        std::error_code Error;
        const auto Written = Files::last_write_time(ToPath(Path), Error);
        if (Error) {
            return FDateTime::MinValue();
        }
        const auto SinceThen = Files::file_time_type::clock::now() - Written;
        return FDateTime::UtcNow() - FTimespan::FromSeconds(std::chrono::duration<double>(SinceThen).count());
    }
};

/** A stdio file that closes itself. */
struct FClose {
    void operator()(std::FILE* File) const { std::fclose(File); }
};
using FFile = std::unique_ptr<std::FILE, FClose>;

} // namespace

IFileManager& IFileManager::Get() {
    static FFileManagerPosix Manager;
    return Manager;
}

bool FFileHelper::LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename, uint32) {
    const FFile File(std::fopen(TCHAR_TO_UTF8(Filename), "rb"));
    if (!File) {
        return false;
    }
    Result.Reset();
    uint8 Block[65536];
    for (size_t Size; (Size = std::fread(Block, 1, sizeof(Block), File.get())) != 0;) {
        Result.Append(Block, static_cast<int32>(Size));
    }
    return std::ferror(File.get()) == 0;
}

void FFileHelper::BufferToString(FString& Result, const uint8* Buffer, int32 Size) {
    Result.Reset();
    const bool bLittle = Size >= 2 && Buffer[0] == 0xFF && Buffer[1] == 0xFE;
    const bool bBig = Size >= 2 && Buffer[0] == 0xFE && Buffer[1] == 0xFF;
    if (bLittle || bBig) {
        for (int32 Index = 2; Index + 1 < Size; Index += 2) {
            Result.AppendChar(static_cast<TCHAR>(
                bLittle ? Buffer[Index] | (Buffer[Index + 1] << 8) : Buffer[Index + 1] | (Buffer[Index] << 8)));
        }
        return;
    }
    const int32 Mark = Size >= 3 && Buffer[0] == 0xEF && Buffer[1] == 0xBB && Buffer[2] == 0xBF ? 3 : 0;
    const std::string Text(reinterpret_cast<const char*>(Buffer) + Mark, static_cast<size_t>(Size - Mark));
    Result = FString(UTF8_TO_TCHAR(Text.c_str()));
}

bool FFileHelper::LoadFileToString(FString& Result, const TCHAR* Filename) {
    TArray<uint8> Bytes;
    if (!LoadFileToArray(Bytes, Filename)) {
        return false;
    }
    BufferToString(Result, Bytes.GetData(), Bytes.Num());
    return true;
}

bool FFileHelper::LoadFileToStringArray(TArray<FString>& Result, const TCHAR* Filename) {
    FString Text;
    if (!LoadFileToString(Text, Filename)) {
        return false;
    }
    Result.Reset();
    Text.ParseIntoArrayLines(Result, false);
    return true;
}

bool FFileHelper::SaveArrayToFile(
    TArrayView<const uint8> Array, const TCHAR* Filename, IFileManager*, uint32 WriteFlags) {
    if ((WriteFlags & FILEWRITE_NoReplaceExisting) && IFileManager::Get().FileExists(Filename)) {
        return false;
    }
    FFile File(std::fopen(TCHAR_TO_UTF8(Filename), (WriteFlags & FILEWRITE_Append) ? "ab" : "wb"));
    if (!File) {
        return false;
    }
    const size_t Size = static_cast<size_t>(Array.Num());
    const bool bWritten = std::fwrite(Array.GetData(), 1, Size, File.get()) == Size;
    return std::fclose(File.release()) == 0 && bWritten; // a full disk may show only here
}

bool FFileHelper::SaveStringToFile(FStringView String, const TCHAR* Filename, EEncodingOptions EncodingOptions,
    IFileManager* FileManager, uint32 WriteFlags) {
    const FString Text(String);
    TArray<uint8> Bytes;
    bool bPlain = true;
    for (int32 Index = 0; Index < Text.Len(); ++Index) {
        bPlain &= Text[Index] < 128;
    }
    if (EncodingOptions == EEncodingOptions::ForceUnicode ||
        (EncodingOptions == EEncodingOptions::AutoDetect && !bPlain)) {
        Bytes.Add(0xFF);
        Bytes.Add(0xFE);
        for (int32 Index = 0; Index < Text.Len(); ++Index) {
            Bytes.Add(static_cast<uint8>(Text[Index]));
            Bytes.Add(static_cast<uint8>(Text[Index] >> 8));
        }
    } else {
        if (EncodingOptions == EEncodingOptions::ForceUTF8) {
            Bytes.Append({0xEF, 0xBB, 0xBF});
        }
        const std::string Encoded(TCHAR_TO_UTF8(*Text));
        Bytes.Append(reinterpret_cast<const uint8*>(Encoded.data()), static_cast<int32>(Encoded.size()));
    }
    return SaveArrayToFile(Bytes, Filename, FileManager, WriteFlags);
}

bool FFileHelper::SaveStringArrayToFile(const TArray<FString>& Lines, const TCHAR* Filename,
    EEncodingOptions EncodingOptions, IFileManager* FileManager, uint32 WriteFlags) {
    FString Text;
    for (const FString& Line : Lines) {
        Text += Line + TEXT("\n");
    }
    return SaveStringToFile(Text, Filename, EncodingOptions, FileManager, WriteFlags);
}
