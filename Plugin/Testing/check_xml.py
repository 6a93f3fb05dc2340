# SPDX-FileCopyrightText: Copyright (c) The Arris developers
# SPDX-License-Identifier: BSD-3-Clause

"""Checks the plugin's XML against the classes: everything documented, every command there, every
parameter of a class among its properties, defaults and output ports those of the class.

    check_xml.py FILTER.xml...
"""

import re
import sys
import xml.etree.ElementTree

import arris

FILTERS = {"vtkSharpEdgeExtractor", "vtkSharpEdgePreview", "vtkSharpEdgeReconstruction",
           "vtkSharpThinningFilter", "vtkSharpeningFilter", "vtkUSSODFilter"}
NOT_FOR_XML = {"SetPickedPointsSharp", "SetPickedPointsSmooth"}  # they take points, not numbers
wrong = []


def expect(holds, message):
    if not holds:
        wrong.append(message)


def check_property(proxy, prop, instance):
    name = f"{proxy.get('name')}.{prop.get('name')}"
    command = prop.get("command")
    for method in filter(None, (command or "none", prop.get("clean_command"))):
        expect(hasattr(instance, method), f"{name}: {proxy.get('class')} has no {method}")
    text = prop.findtext("Documentation", "").strip()
    expect(len(text) > 20 and text.endswith("."), f"{name}: not documented")
    label = prop.get("label", prop.get("name"))
    expect("".join(c for c in label if c.isascii() and c.isalnum()) == prop.get("name"),
           f"{name}: Python would know it by another name, made of its label {label!r}")
    domains = [child for child in prop if child.tag.endswith("Domain")]
    free = prop.get("information_only") or prop.tag == "StringVectorProperty"
    expect(domains or free, f"{name}: no domain")
    if command and re.fullmatch("Set(?!Input).*", command):
        default = prop.get("default_values")
        default = default if prop.tag == "StringVectorProperty" else float(default)
        getter = getattr(instance, "Get" + command[3:], lambda: None)
        expect(getter() == default, f"{name}: default {default}, of the class {getter()}")


def check_proxy(proxy):
    name = proxy.get("name")
    kind = getattr(arris, proxy.get("class"), None)
    if kind is None:
        expect(False, f"{name}: there is no class {proxy.get('class')}")
        return
    instance = kind()
    properties = [child for child in proxy if child.tag.endswith("Property")]
    for prop in properties:
        check_property(proxy, prop, instance)

    documentation = proxy.find("Documentation")
    expect(documentation is not None and documentation.text.strip()
           and documentation.get("short_help") and documentation.get("long_help"),
           f"{name}: short help, long help or documentation is missing")
    menu = proxy.find("Hints/ShowInMenu")
    expect(menu is not None and menu.get("category") == "Arris" and menu.get("icon"),
           f"{name}: not in the menu Arris with an icon")
    shown = [prop for prop in properties if prop.get("panel_visibility") is None
             and prop.get("information_only") is None and prop.tag != "InputProperty"]
    expect(len(shown) <= 7, f"{name}: {len(shown)} properties are in the panel by default")

    ports = [port.get("name") for port in proxy.findall("OutputPort")]
    expect(len(ports) == instance.GetNumberOfOutputPorts() and all(ports),
           f"{name}: names {len(ports)} of {instance.GetNumberOfOutputPorts()} output ports")

    commands = {prop.get("command") for prop in properties}
    ours = [cls for cls in kind.__mro__ if cls.__module__.startswith("arris")]
    for method in set().union(*map(vars, ours)) - NOT_FOR_XML:
        parameter = re.fullmatch("Set((?!.*To[A-Z]).*)", method)
        if parameter and hasattr(kind, "Get" + parameter[1]):
            expect(method in commands, f"{name}: {method} has no property")


def main():
    roots = [xml.etree.ElementTree.parse(name).getroot() for name in sys.argv[1:]]
    proxies = [proxy for root in roots
               for proxy in root.findall("ProxyGroup[@name='filters']/SourceProxy")]
    classes = {proxy.get("class") for proxy in proxies}
    expect(classes == FILTERS, f"not the filters of Arris: {sorted(classes ^ FILTERS)}")
    for proxy in proxies:
        check_proxy(proxy)
    for message in wrong:
        print("WRONG:", message)
    print(f"{len(proxies)} proxies checked, {len(wrong)} complaints")
    return 1 if wrong else 0


sys.exit(main())
