package-sympy_missing = Ein eigenes Sensormodell herzuleiten braucht das Paket SymPy.
    .do = Ausführen: pip install 'raybundle[models]'

package-pyarrow_missing = Parquet-Tabellen brauchen das Paket pyarrow.
    .do = Ausführen: pip install 'raybundle[parquet]'

package-ezdxf_missing = DXF zu schreiben braucht das Paket ezdxf.
    .do = Ausführen: pip install 'raybundle[geo]'

package-pyogrio_missing = Ein GeoPackage zu schreiben braucht das Paket pyogrio.
    .do = pip install 'raybundle[geo]' ausführen oder GeoJSON schreiben.

package-laspy_missing = LAS-Dateien brauchen das Paket laspy.
    .do = Ausführen: pip install 'raybundle[las]'

package-rasterio_missing = Raster brauchen das Paket rasterio.
    .do = Ausführen: pip install 'raybundle[geo]'

package-reportlab_missing = PDF zu schreiben braucht das Paket reportlab.
    .do = pip install reportlab ausführen oder .svg schreiben.

package-pyogrio_reading = Dieses Format zu lesen erfordert das Paket pyogrio.
    .do = pip install 'raybundle[geo]' ausführen oder die Passpunkte als GeoJSON oder CSV speichern.

package-contourpy_missing = Höhenlinien erfordern das Paket contourpy.
    .do = pip install 'raybundle[geo]' ausführen.

package-rioxarray_missing = Die Karte als DataArray zu lesen braucht das Paket rioxarray.
    .do = Ausführen: pip install rioxarray

package-several_missing = { $n } Pakete fehlen:
    .do = Die unten genannten Pakete installieren.

package-typst_missing = Ein Bericht als PDF benötigt das Paket typst.
    .do = Ausführen: pip install 'raybundle[pdf]'

package-matplotlib_missing = Abbildungen benötigen das Paket matplotlib.
    .do = Ausführen: pip install 'raybundle[plots]'

package-tables_missing = Das Paket { $package } ist nicht installiert.
    .do = pip install { $package } ausführen oder { OPTION("to", "numpy") } angeben.

package-h5py_missing = Szenen in HDF5 brauchen das Paket h5py.
    .do = Ausführen: pip install 'raybundle[radar]'
