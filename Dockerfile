# syntax=docker/dockerfile:1
# The wheel is built in the first stage; the second has Python, the package and what it requires, and no compiler.
#   docker build --tag raybundle .
#   docker run --rm --volume "$PWD:/data" --user "$(id -u):$(id -g)" raybundle orient photos --out project
ARG PYTHON=3.13
# as [cluster] or [pdf,las]
ARG EXTRAS=""

FROM python:${PYTHON}-slim-bookworm AS build
# hadolint ignore=DL3008
RUN apt-get update \
    && apt-get install --yes --no-install-recommends g++ \
    && rm -rf /var/lib/apt/lists/*
RUN python -m pip install --no-cache-dir "build==1.6.1"
COPY . /source
WORKDIR /source
ENV RAYBUNDLE_REQUIRE_NATIVE=1
RUN python -m build --wheel --outdir /dist

FROM python:${PYTHON}-slim-bookworm
ARG EXTRAS
COPY --from=build /dist /dist
# hadolint ignore=DL3013
RUN python -m pip install --no-cache-dir "$(echo /dist/*.whl)${EXTRAS}" \
    && rm -r /dist \
    && useradd --create-home --uid 1000 raybundle \
    && install --directory --owner raybundle /data
USER 1000:1000
# what is kept between runs stands where any user may write
ENV HOME=/tmp PYTHONUTF8=1
WORKDIR /data
ENTRYPOINT ["raybundle"]
CMD ["--help"]
