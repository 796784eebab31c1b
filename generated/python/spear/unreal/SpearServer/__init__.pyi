# generated, do not edit (SpearServer)
"""Types of Unreal's module SpearServer."""
from ._SpearLatentReceiver import USpearLatentReceiver as USpearLatentReceiver, USpearLatentReceiver_path as USpearLatentReceiver_path
