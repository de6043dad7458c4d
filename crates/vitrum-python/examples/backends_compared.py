# %% [markdown]
# # The same kernels on processor and GPU
#
# Each kernel is written once; the picture is the same to the bit where the driver takes SPIR-V as it is.

# %%
import numpy as np

import vitrum_render as vr

z, y, x = np.mgrid[-1:1:48j, -1:1:48j, -1:1:48j]
volume = np.exp(-4 * (x * x + 2 * y * y + z * z)).astype(np.float32)

# %%
pictures = {}
for device in vr.devices():
    print(f"{device['backend']}: {device['name']} ({device['kind']}; {device['driver']})")
    if device["backend"] in pictures:
        continue
    picture = vr.render(volume, preset="glass", size=(320, 240), backend=device["backend"])
    pictures[device["backend"]] = picture
    kernels = sorted(picture.statistics["kernels"], key=lambda kernel: -kernel["ms"])
    for kernel in kernels[:4]:
        print(f"  {kernel['kernel']:32} {kernel['ms']:9.2f} ms")

# %%
if len(pictures) == 2:
    difference = vr.diff(pictures["cpu"], pictures["gpu"])
    print(f"largest difference {difference.max_abs:.2e}, ꟻLIP {difference.mean_flip:.2e}")
pictures["cpu"].save("backends_compared.png")
