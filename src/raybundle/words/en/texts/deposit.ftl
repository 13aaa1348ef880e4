# $n = 24
# $mb = 12.3
deposit-written = Packed: { $n } files, { NUM($mb, digits: 3) } MB.

# $entry = "result"
deposit-content = { $entry ->
        [result] current result: report, tables, block; its README.txt names each file and column
        [surface] products of the surface
        [facade] products of the facade
        [photographs] photographs
        [project_toml] parameters of the runs, and the recording sheet
        [measurements_json] journal of what was measured by hand
        [photographs_sha256] checksums of the photographs
        [checksums_sha256] checksums of all files: sha256sum -c checksums.sha256
       *[ro_crate_metadata_json] description of the package (RO-Crate 1.1)
    }

# $of = ["Town hall", "Göttingen"]
deposit-description = Photogrammetric recording: orientations, coordinates, precision. { LIST($of, most: 3) }

deposit-adjustment = Orientation and bundle adjustment
