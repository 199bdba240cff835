# SPDX-FileCopyrightText: Copyright (c) SurfaceDenoising contributors
# SPDX-License-Identifier: BSD-3-Clause
"""What the XML of the plugin says agrees with the classes: names, settings, defaults and texts."""

import inspect

import surfacedenoising
from paraview import make_name_valid, servermanager
from vtkmodules.vtkCommonExecutionModel import vtkPolyDataAlgorithm

problems = []


def expect(condition, *message):
    if not condition:
        problems.append(": ".join(str(part) for part in message))


def concrete_filters():
    """Name of the proxy and an object for every filter of the package."""
    for name, cls in inspect.getmembers(surfacedenoising, inspect.isclass):
        if issubclass(cls, vtkPolyDataAlgorithm) and not name.endswith("Reader"):
            try:
                yield name[len("vtk"):], cls()
            except TypeError:
                pass  # abstract


def properties(proxy):
    iterator = proxy.NewPropertyIterator()
    iterator.UnRegister(None)
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def settings(vtk_object):
    """Names X of all pairs SetX, GetX that the classes of the project add."""
    added = set(dir(vtk_object)) - set(dir(vtkPolyDataAlgorithm))
    return {name[3:] for name in added if name.startswith("Set") and "G" + name[1:] in added}


def normalized(text):
    return text.replace(" ", "").replace("_", "").lower()


def check_proxy(name, proxy, vtk_object):
    expect(proxy.GetVTKClassName() == vtk_object.GetClassName(), name, "is of another class")
    expect(make_name_valid(proxy.GetXMLLabel()) == name, name, "label", proxy.GetXMLLabel())
    texts = proxy.GetDocumentation()
    expect(0 < len(texts.GetShortHelp() or "") <= 80, name, "short help has 1 to 80 letters")
    expect(texts.GetLongHelp(), name, "no long help")
    expect(len(texts.GetDescription() or "") > 200, name, "the description says little")
    menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
    expect(menu.GetAttribute("category") == "Surface Denoising", name, "menu")
    expect(proxy.GetProcessSupport() == proxy.SINGLE_PROCESS, name, "has no parallel version")


def check_panel(name, proxy):
    """All that the panel shows is in a group, and what hides it is there."""
    groups = [proxy.GetPropertyGroup(i) for i in range(proxy.GetNumberOfPropertyGroups())]
    members = {group.GetProperty(i).GetXMLName()
               for group in groups for i in range(group.GetNumberOfProperties())}
    for key, prop in properties(proxy):
        if not prop.IsA("vtkSMInputProperty") and prop.GetPanelVisibility() != "never":
            expect(key in members, name, key, "is in no group")
    for part in groups + [prop for _, prop in properties(proxy)]:
        hints = part.GetHints()
        decorator = hints and hints.FindNestedElementByName("PropertyWidgetDecorator")
        if decorator:
            other = decorator.GetAttribute("property")
            expect(proxy.GetProperty(other), name, "a decorator asks for", other)


def check_enumeration(where, name, domain, vtk_object):
    entries = {domain.GetEntryText(i): domain.GetEntryValue(i)
               for i in range(domain.GetNumberOfEntries())}
    if name == "Norm":
        names = {vtk_object.GetNormName(i): i for i in range(vtk_object.GetNumberOfNorms())}
        expect(entries == names, where, "the dropdown has", entries, "the class", names)
        return
    constants = {normalized(attribute): getattr(vtk_object, attribute)
                 for attribute in dir(type(vtk_object))
                 if isinstance(getattr(type(vtk_object), attribute), int)}
    for text, value in entries.items():
        expect(constants.get(normalized(text)) == value, where, text, "is no enumerator of value",
               value)
    # The setters clamp: what is left of a huge value is the last enumerator.
    default = getattr(vtk_object, "Get" + name)()
    getattr(vtk_object, "Set" + name)(10 ** 6)
    last = getattr(vtk_object, "Get" + name)()
    getattr(vtk_object, "Set" + name)(default)
    expect(sorted(entries.values()) == list(range(last + 1)), where, "the dropdown has", entries)


def check_property(where, name, prop, vtk_object):
    expect(make_name_valid(prop.GetXMLLabel()) == name, where, "label", prop.GetXMLLabel())
    texts = prop.GetDocumentation()
    expect(texts and (texts.GetDescription() or "").strip(), where, "no documentation")
    command = prop.GetCommand()
    expect(hasattr(vtk_object, command), where, "no method", command)
    if prop.GetInformationOnly():
        expect(command == "Get" + name, where, "command", command)
        return
    if command in ("SetInputConnection", "SetInputArrayToProcess"):
        return
    expect(command == "Set" + name, where, "command", command)
    value = getattr(vtk_object, "Get" + name)()
    default = prop.GetElement(0)  # a prototype has its default values
    expect(default == value, where, "default", default, "of the class", value)
    domain = prop.FindDomain("vtkSMEnumerationDomain")
    if domain:
        check_enumeration(where, name, domain, vtk_object)


servermanager.Connect()
manager = servermanager.ProxyManager()
checked = 0
for filter_name, filter_object in concrete_filters():
    prototype = manager.GetPrototypeProxy("filters", filter_name)
    if not prototype:
        expect(False, filter_name, "the plugin has no such proxy")
        continue
    check_proxy(filter_name, prototype, filter_object)
    check_panel(filter_name, prototype)
    found = dict(properties(prototype))
    for property_name, sm_property in found.items():
        check_property(filter_name + "." + property_name, property_name, sm_property, filter_object)
    missing = settings(filter_object) - set(found)
    expect(not missing, filter_name, "settings that the XML lacks", sorted(missing))
    checked += 1

assert checked >= 5, "only {} filters were found".format(checked)
assert not problems, "\n" + "\n".join(problems)
