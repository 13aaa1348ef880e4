"""Heights, meshes, planes of pictures, pictures of scenes, tables in pieces, archives of arrays."""

from pathlib import Path

import numpy as np

from tests.hostile.readers.blocks import small_block
from tests.hostile.readers.registry import not_finite, only, place, target, texts, wrong_in_block
from tests.hostile.readers.scenes import small_rpc

MESH = "v 0 0 0\nv 4 0 0\nv 4 3 1\nv 0 3 1\nf 1 2 3\nf 1 3 4\n"
PLY = (
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
)
PLANE = (
    "left = 10.0\ntop = 4.5\npixel = 0.002\norigin = [0.0, 0.0, 0.0]\nright = [1.0, 0.0, 0.0]\nup = [0.0, 0.0, 1.0]\n"
    'normal = [0.0, -1.0, 0.0]\nsystem = ""\nunit = "m"\npoints_rms = 0.003\npoints = 41\nscale = "fixed"\n'
    '[stations]\n"a.jpg" = [1.0, -5.0, 1.6]\n'
)


def height_seeds(top: Path) -> None:
    from tests.surface.height_models import folder_of, made

    folder_of(made(np.zeros((40, 36)), common=1e-3), place(top))


def read_the_heights(folder: Path) -> list[str]:
    from raybundle.surfaces.files.heights import read_heights

    model, file = read_heights(folder)
    wrong = not_finite(sigma=model.sigma[model.known], place=[file.left, file.top, file.cell])
    return wrong + ([] if model.shape == (file.height, file.width) else ["shape"])


def raster_seeds(top: Path) -> None:
    import rasterio

    for k, crs in enumerate(("EPSG:32632", "EPSG:4326")):
        step = 10.0 if k == 0 else 1e-4
        origin = (500000.0, 5300000.0) if k == 0 else (9.0, 47.8535)
        with rasterio.open(
            place(top, k) / "h.tif", "w", driver="GTiff", width=24, height=20, count=1, dtype="float32", crs=crs,
            nodata=-9999.0, transform=rasterio.Affine(step, 0, origin[0], 0, -step, origin[1]),
        ) as file:  # fmt: skip
            file.write((np.add.outer(np.arange(20.0), np.arange(24.0)) + 400).astype(np.float32), 1)


def read_a_raster(folder: Path) -> list[str]:
    from raybundle.io.geo.rasters import read_all_heights, read_heights

    box = np.array([[500020.0, 5299850.0], [500150.0, 5299950.0]])
    grids = [read_all_heights(only(folder), "EPSG:32632"), read_heights(only(folder), "EPSG:32632", box)]
    return [w for g in grids for w in not_finite(place=[*g.origin, *g.column, *g.row])]


def cloud_seeds(top: Path) -> None:
    import laspy

    header = laspy.LasHeader(point_format=3, version="1.4")
    header.offsets, header.scales = [500000.0, 5300000.0, 400.0], [1e-3] * 3
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = 500000.0 + np.arange(40.0), 5300000.0 + np.arange(40.0), 400.0 + np.arange(40.0)
    cloud.write(str(place(top) / "c.las"))


def read_a_cloud(folder: Path) -> list[str]:
    from raybundle.io.formats.las import read_las

    return [w for xyz, _ in read_las(only(folder)) for w in not_finite(xyz=xyz)]


def read_a_mesh(folder: Path) -> list[str]:
    from raybundle.io.meshes import read_mesh

    return not_finite(triangles=read_mesh(only(folder)).triangles)


def read_a_plane(folder: Path) -> list[str]:
    from raybundle.io.pictures.plane_file import read_plane

    plane = read_plane(only(folder))
    return not_finite(place=[plane.left, plane.top, plane.pixel])


def picture_seeds(top: Path) -> None:
    from raybundle.io.scenes.rpc_text import write_rpc_text
    from tests.scenes.test_rpc_writing import write_picture

    folder = place(top)
    write_picture(folder / "a.tif", None)
    write_rpc_text(small_rpc(), folder / "a_RPC.TXT")


def read_a_picture(folder: Path) -> list[str]:
    from raybundle.workflows.scenes.images import find_scenes

    found = find_scenes([folder])
    return [w for s in found.scenes for w in not_finite(size=[s.width_px, s.height_px])]


def pieces_seeds(top: Path) -> None:
    from raybundle.io.block.folder import write_block

    write_block(small_block().observed, top / "0", tables="parquet")


def read_pieces(folder: Path) -> list[str]:
    from raybundle.io.block.pieces import read_in_pieces

    return wrong_in_block(read_in_pieces(folder).whole())


def archive_seeds(top: Path) -> None:
    from raybundle.pipeline.archives import write_archive

    with (place(top) / "a.npz").open("wb") as file:
        write_archive(file, {"xyz": np.arange(12.0).reshape(4, 3), "ids": np.array(["a", "bb"])})


def read_an_archive(folder: Path) -> list[str]:
    from raybundle.pipeline.archives import DAMAGED, members_of, read_member

    try:
        with only(folder).open("rb") as file:
            found = {name: read_member(file, m) for name, m in members_of(file).items()}
    except DAMAGED:
        return []
    # what is read has passed its check sum: it is what was written, or an array was lost from the directory
    return [] if "xyz" not in found or np.array_equal(found["xyz"].ravel(), np.arange(12.0)) else ["other numbers"]


target("heights", height_seeds, read_the_heights, slow=True)
target("heights-raster", raster_seeds, read_a_raster, slow=True)
target("cloud", cloud_seeds, read_a_cloud)
target("mesh", texts({"m.obj": MESH}, {"m.ply": PLY}), read_a_mesh)
target("plane", texts({"p.toml": PLANE}), read_a_plane)
target("scene-picture", picture_seeds, read_a_picture)
target("block-pieces", pieces_seeds, read_pieces)
target("archive", archive_seeds, read_an_archive)
