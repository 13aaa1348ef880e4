package-sympy_missing = Deriving an own sensor model needs the package SymPy.
    .do = Run: pip install 'raybundle[models]'

package-pyarrow_missing = Parquet tables need the package pyarrow.
    .do = Run: pip install 'raybundle[parquet]'

package-ezdxf_missing = Writing DXF needs the package ezdxf.
    .do = Run: pip install 'raybundle[geo]'

package-pyogrio_missing = Writing a GeoPackage needs the package pyogrio.
    .do = Run pip install 'raybundle[geo]', or write GeoJSON.

package-laspy_missing = LAS files need the package laspy.
    .do = Run: pip install 'raybundle[las]'

package-rasterio_missing = Rasters need the package rasterio.
    .do = Run: pip install 'raybundle[geo]'

package-reportlab_missing = Writing a PDF needs the package reportlab.
    .do = Run pip install reportlab, or write .svg.

package-pyogrio_reading = Reading this format needs the package pyogrio.
    .do = Run pip install 'raybundle[geo]', or save the control as GeoJSON or CSV.

package-contourpy_missing = Contour lines need the package contourpy.
    .do = Run pip install 'raybundle[geo]'.

package-rioxarray_missing = Reading the map as a DataArray needs the package rioxarray.
    .do = Run: pip install rioxarray

# $n = 2
package-several_missing = { $n } packages are missing:
    .do = Install the packages named below.

package-typst_missing = A report as PDF needs the package typst.
    .do = Run: pip install 'raybundle[pdf]'

package-matplotlib_missing = Figures need the package matplotlib.
    .do = Run: pip install 'raybundle[plots]'

# $package = "polars"
package-tables_missing = The package { $package } is not installed.
    .do = Run pip install { $package }, or give { OPTION("to", "numpy") }.

package-h5py_missing = Scenes in HDF5 need the package h5py.
    .do = Run: pip install 'raybundle[radar]'
