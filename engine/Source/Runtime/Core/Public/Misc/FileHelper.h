// SPDX-License-Identifier: MIT
/** FFileHelper: whole files at once. Text is read as UTF-8 (with or without mark) or UTF-16 (with mark). */
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/EnumClassFlags.h"

enum EFileWrite : uint32 {
    FILEWRITE_None = 0x00,
    FILEWRITE_NoFail = 0x01,
    FILEWRITE_NoReplaceExisting = 0x02,
    FILEWRITE_EvenIfReadOnly = 0x04,
    FILEWRITE_Append = 0x08,
    FILEWRITE_AllowRead = 0x10,
    FILEWRITE_Silent = 0x20,
};

class IFileManager;

struct FFileHelper {
    enum class EEncodingOptions { AutoDetect, ForceAnsi, ForceUnicode, ForceUTF8, ForceUTF8WithoutBOM };

    static CORE_API bool LoadFileToArray(TArray<uint8>& Result, const TCHAR* Filename, uint32 Flags = 0);
    static CORE_API bool LoadFileToString(FString& Result, const TCHAR* Filename);
    static CORE_API bool LoadFileToStringArray(TArray<FString>& Result, const TCHAR* Filename);
    /** Decodes bytes as a file's would be. */
    static CORE_API void BufferToString(FString& Result, const uint8* Buffer, int32 Size);
    static CORE_API bool SaveArrayToFile(TArrayView<const uint8> Array, const TCHAR* Filename,
        IFileManager* FileManager = nullptr, uint32 WriteFlags = 0);
    static CORE_API bool SaveStringToFile(FStringView String, const TCHAR* Filename,
        EEncodingOptions EncodingOptions = EEncodingOptions::AutoDetect, IFileManager* FileManager = nullptr,
        uint32 WriteFlags = 0);
    static CORE_API bool SaveStringArrayToFile(const TArray<FString>& Lines, const TCHAR* Filename,
        EEncodingOptions EncodingOptions = EEncodingOptions::AutoDetect, IFileManager* FileManager = nullptr,
        uint32 WriteFlags = 0);
};
