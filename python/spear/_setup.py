# SPDX-License-Identifier: MIT
"""Tells the native half which Python classes to make: objects, structs, enums, results, errors."""

from __future__ import annotations

from spear import _native, enums, errors, naming, nulls, results, structs
from spear.unreal_object import AsyncNamespace, FutureObject, Member, SendNamespace, UnrealObject, check_assignment

_native.setup(
    object_class=UnrealObject, struct_base=structs.Struct, struct_class=structs.announced, enum_class=enums.announced,
    enum_entries=enums.wire_entries, result_class=results.result_class, null_result=nulls.null_result,
    parameter_name=naming.parameter_name, errors=errors.BY_NAME, future_object=FutureObject,
    member_class=Member, async_namespace=AsyncNamespace, send_namespace=SendNamespace, renamed=naming.renamed,
    unreal_name_of=naming.unreal_name_of, check_assignment=check_assignment,
)
