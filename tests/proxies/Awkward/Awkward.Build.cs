// SPDX-License-Identifier: MIT
public class Awkward : ModuleRules
{
}
