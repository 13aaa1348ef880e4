package-sympy_missing = La dérivation d'un modèle de capteur demande le paquet SymPy.

package-pyarrow_missing = Les tables Parquet demandent le paquet pyarrow.

package-ezdxf_missing = L'écriture de DXF demande le paquet ezdxf.

package-pyogrio_missing = L'écriture d'un GeoPackage demande le paquet pyogrio.

package-laspy_missing = Les fichiers LAS demandent le paquet laspy.

package-rasterio_missing = Les rasters demandent le paquet rasterio.

package-reportlab_missing = Écrire un PDF demande le paquet reportlab.

package-pyogrio_reading = La lecture de ce format exige le paquet pyogrio.

package-contourpy_missing = Les courbes de niveau exigent le paquet contourpy.

package-rioxarray_missing = La lecture de la carte comme DataArray demande le paquet rioxarray.

package-several_missing = { $n } paquets manquent :

package-typst_missing = Un rapport en PDF a besoin du paquet typst.

package-matplotlib_missing = Les figures ont besoin du paquet matplotlib.

package-tables_missing = Le paquet { $package } n'est pas installé.

package-h5py_missing = Les scènes en HDF5 demandent le paquet h5py.
