# generated, do not edit (all modules)
"""Types of Unreal by their modules: ``from spear.unreal.Engine import AActor``.

Modules here: CoreUObject, Engine, SpearServer. ``spear schema stubs`` writes those of your own project.
"""
