attitudes_nominal = La rotation du bloc autour de la ligne de ses positions repose sur les attitudes seules.
