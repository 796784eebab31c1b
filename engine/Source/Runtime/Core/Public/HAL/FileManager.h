// SPDX-License-Identifier: MIT
/** IFileManager: files and directories. */
#pragma once

#include "Containers/UnrealString.h"
#include "Misc/DateTime.h"

class IFileManager {
public:
    static CORE_API IFileManager& Get();
    virtual ~IFileManager() = default;
    virtual bool FileExists(const TCHAR* Filename) = 0;
    virtual bool DirectoryExists(const TCHAR* InDirectory) = 0;
    /** In bytes, or INDEX_NONE. */
    virtual int64 FileSize(const TCHAR* Filename) = 0;
    virtual bool Delete(
        const TCHAR* Filename, bool RequireExists = false, bool EvenReadOnly = false, bool Quiet = false) = 0;
    virtual bool Move(const TCHAR* Dest, const TCHAR* Src, bool bReplace = true) = 0;
    /** 0 on success. */
    virtual uint32 Copy(const TCHAR* Dest, const TCHAR* Src, bool bReplace = true) = 0;
    virtual bool MakeDirectory(const TCHAR* Path, bool Tree = false) = 0;
    virtual bool DeleteDirectory(const TCHAR* Path, bool RequireExists = false, bool Tree = false) = 0;
    /** Names (without path) of what matches the last part of the path, in alphabetical order. */
    virtual void FindFiles(TArray<FString>& FileNames, const TCHAR* Filename, bool Files, bool Directories) = 0;
    /** Full paths below a directory, in alphabetical order. */
    virtual void FindFilesRecursive(TArray<FString>& FileNames, const TCHAR* StartDirectory, const TCHAR* Filename,
        bool Files, bool Directories, bool bClearFileNames = true) = 0;
    virtual FDateTime GetTimeStamp(const TCHAR* Path) = 0;
};
