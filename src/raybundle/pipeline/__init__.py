"""Stages, tasks and where their products are kept: what is done is known by its content, never done twice.

keys        what a product depends on, as a hash
archives    the files of products: arrays that can be mapped one by one, each with its check sum
store       products of tasks and stages in files, whole or not at all
objects     the same in an object store, by a URL
stores      whether products may lie where a run is reported; `confirmed_stores` at URLs of this machine's user
project     a project folder: store, small products and records of stages in SQLite, one run at a time
tasks       what another process can do by itself: a function by name, plain options, keys of products
queues      in which order tasks are handed over, and what becomes of those that fail
executors   who does tasks: threads of this process, or processes of their own
clusters    where a cluster is, by its folder: address, certificates, version
on_dask     who does tasks: workers of a scheduler; with `dask_machines` the only module that knows Dask
shards      who does tasks: jobs of an array, by a list in the store
choosing    which of them does those of a run
stage       a step of a workflow as a value, and the run that gives it products, executors and progress
"""
