struct type_5 {
member: array<f32>,
}
struct type_8 {
member: array<u32>,
}
struct type_9 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: vec4<u32>,
}
struct type_10 {
member: type_9,
}
struct type_13 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_10;
@group(0) @binding(3)
var<storage, read_write> global_2: type_13;
@group(0) @binding(2)
var<storage> global_3: type_8;
@group(0) @binding(1)
var<storage> global_4: type_5;
fn function_() {
var phi_144_: i32;
var phi_326_: i32;
var phi_594_: i32;
var phi_726_: i32;
var phi_727_: i32;
var phi_595_: i32;
var phi_327_: i32;
let _e29 = global;
let _e35 = arrayLength((&global_2.member));
let _e39 = global_1.member.member[0u];
let _e43 = global_1.member.member[1u];
if (_e29.x < _e39) {
if (_e29.y < _e43) {
let _e49 = ((_e29.y * _e39) + _e29.x);
let _e53 = global_1.member.member[3u];
let _e55 = bitcast<i32>((_e49 * 3u));
let _e56 = (_e55 + 1i);
let _e58 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e60 = select(_e58, _e56, (_e56 < _e58));
let _e66 = global_3.member[bitcast<u32>(select(0i, _e60, (_e60 > 0i)))];
let _e67 = bitcast<i32>(_e66);
if (_e49 < _e53) {
let _e69 = (_e55 + 2i);
let _e71 = select(_e58, _e69, (_e69 < _e58));
let _e77 = global_3.member[bitcast<u32>(select(0i, _e71, (_e71 > 0i)))];
phi_144_ = bitcast<i32>(_e77);
} else {
phi_144_ = 0i;
}
let _e80 = phi_144_;
let _e82 = select(_e58, _e55, (_e55 < _e58));
let _e88 = global_3.member[bitcast<u32>(select(0i, _e82, (_e82 > 0i)))];
let _e91 = (bitcast<i32>(_e88) * 9i);
let _e93 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e95 = select(_e93, _e91, (_e91 < _e93));
let _e101 = global_4.member[bitcast<u32>(select(0i, _e95, (_e95 > 0i)))];
let _e102 = (_e91 + 1i);
let _e104 = select(_e93, _e102, (_e102 < _e93));
let _e110 = global_4.member[bitcast<u32>(select(0i, _e104, (_e104 > 0i)))];
let _e111 = (_e91 + 2i);
let _e113 = select(_e93, _e111, (_e111 < _e93));
let _e119 = global_4.member[bitcast<u32>(select(0i, _e113, (_e113 > 0i)))];
let _e120 = (_e91 + 3i);
let _e122 = select(_e93, _e120, (_e120 < _e93));
let _e128 = global_4.member[bitcast<u32>(select(0i, _e122, (_e122 > 0i)))];
let _e129 = (_e91 + 4i);
let _e131 = select(_e93, _e129, (_e129 < _e93));
let _e137 = global_4.member[bitcast<u32>(select(0i, _e131, (_e131 > 0i)))];
let _e138 = (_e91 + 5i);
let _e140 = select(_e93, _e138, (_e138 < _e93));
let _e146 = global_4.member[bitcast<u32>(select(0i, _e140, (_e140 > 0i)))];
let _e147 = (_e91 + 6i);
let _e149 = select(_e93, _e147, (_e147 < _e93));
let _e155 = global_4.member[bitcast<u32>(select(0i, _e149, (_e149 > 0i)))];
let _e156 = (_e91 + 7i);
let _e158 = select(_e93, _e156, (_e156 < _e93));
let _e164 = global_4.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e165 = (_e91 + 8i);
let _e167 = select(_e93, _e165, (_e165 < _e93));
let _e173 = global_4.member[bitcast<u32>(select(0i, _e167, (_e167 > 0i)))];
let _e177 = global_1.member.member_2[0u];
let _e178 = (_e177 & 31u);
let _e181 = f32((1u << bitcast<u32>(_e178)));
let _e182 = (1f / _e181);
let _e186 = global_1.member.member_2[2u];
let _e190 = f32((1u << bitcast<u32>((_e186 & 31u))));
let _e194 = global_1.member.member_1[0u];
let _e195 = f32(_e194);
phi_326_ = _e67;
loop {
let _e197 = phi_326_;
let _e198 = (_e197 < (_e67 + _e80));
if _e198 {
let _e201 = ((f32(_e197) + 0.5f) * _e182);
let _e202 = (_e119 <= _e201);
let _e203 = (_e146 > _e201);
let _e204 = (_e202 && _e203);
let _e205 = (_e146 <= _e201);
let _e206 = (_e119 > _e201);
let _e207 = (_e205 && _e206);
let _e208 = select(_e128, _e101, _e204);
let _e210 = select(_e137, _e110, _e204);
let _e212 = select(_e146, _e119, _e204);
let _e218 = ((_e201 - _e212) / select(1f, (select(_e119, _e146, _e204) - _e212), (_e204 || _e207)));
let _e221 = (_e208 + ((select(_e101, _e128, _e204) - _e208) * _e218));
let _e224 = (_e210 + ((select(_e110, _e137, _e204) - _e210) * _e218));
let _e225 = (_e173 > _e201);
let _e226 = (_e205 && _e225);
let _e227 = (_e173 <= _e201);
let _e228 = (_e227 && _e203);
let _e229 = select(_e155, _e128, _e226);
let _e231 = select(_e164, _e137, _e226);
let _e233 = select(_e173, _e146, _e226);
let _e239 = ((_e201 - _e233) / select(1f, (select(_e146, _e173, _e226) - _e233), (_e226 || _e228)));
let _e242 = (_e229 + ((select(_e128, _e155, _e226) - _e229) * _e239));
let _e245 = (_e231 + ((select(_e137, _e164, _e226) - _e231) * _e239));
let _e246 = (_e227 && _e206);
let _e248 = select(_e101, _e155, _e246);
let _e250 = select(_e110, _e164, _e246);
let _e252 = select(_e119, _e173, _e246);
let _e258 = ((_e201 - _e252) / select(1f, (select(_e173, _e119, _e246) - _e252), (_e246 || (_e202 && _e225))));
let _e261 = (_e248 + ((select(_e155, _e101, _e246) - _e248) * _e258));
let _e264 = (_e250 + ((select(_e164, _e110, _e246) - _e250) * _e258));
let _e268 = select(select(_e264, _e245, _e226), _e224, _e204);
let _e270 = select(select(_e261, _e242, _e228), _e221, _e207);
let _e272 = select(select(_e264, _e245, _e228), _e224, _e207);
let _e275 = (_e268 > _e272);
if ((_e204 || _e226) || _e246) {
let _e286 = global_1.member.member_1[1u];
let _e291 = -(((select(_e272, _e268, _e275) * _e181) - 0.5f));
let _e292 = -((f32(_e286) * _e181));
let _e294 = select(_e292, _e291, (_e291 > _e292));
let _e296 = select(0f, _e294, (_e294 < 0f));
let _e303 = select(0i, select(select(i32(_e296), i32(-2147483648), (_e296 < -2147483600f)), 2147483647i, (_e296 > 2147483500f)), (_e296 == _e296));
let _e311 = -(((select(_e272, _e268, (_e268 < _e272)) * _e181) - 0.5f));
let _e313 = select(_e292, _e311, (_e311 > _e292));
let _e315 = select(0f, _e313, (_e313 < 0f));
let _e322 = select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < -2147483600f)), 2147483647i, (_e315 > 2147483500f)), (_e315 == _e315));
let _e333 = global_1.member.member_2[1u];
phi_594_ = -((_e322 - select(0i, 1i, (_e315 < f32(_e322)))));
loop {
let _e337 = phi_594_;
let _e338 = (_e337 < -((_e303 - select(0i, 1i, (_e296 < f32(_e303))))));
if _e338 {
let _e343 = ((((f32(_e337) + 0.5f) * _e182) - _e272) * (1f / select((_e268 - _e272), 1f, (_e268 == _e272))));
let _e345 = select(0f, _e343, (_e343 > 0f));
let _e350 = (_e270 + ((select(select(_e261, _e242, _e226), _e221, _e204) - _e270) * select(1f, _e345, (_e345 < 1f))));
let _e352 = select(0f, _e350, (_e350 > 0f));
let _e354 = select(_e195, _e352, (_e352 < _e195));
let _e355 = (_e195 - 1f);
let _e357 = select(0f, _e354, (_e354 > 0f));
let _e359 = select(_e355, _e357, (_e357 < _e355));
let _e366 = select(0i, select(select(i32(_e359), i32(-2147483648), (_e359 < -2147483600f)), 2147483647i, (_e359 > 2147483500f)), (_e359 == _e359));
let _e370 = (_e366 - select(0i, 1i, (_e359 < f32(_e366))));
let _e372 = select(0f, _e190, (_e190 > 0f));
let _e374 = select(65536f, _e372, (_e372 < 65536f));
let _e381 = select(0i, select(select(i32(_e374), i32(-2147483648), (_e374 < -2147483600f)), 2147483647i, (_e374 > 2147483500f)), (_e374 == _e374));
let _e389 = (((_e354 - f32(_e370)) * _e190) + 0.5f);
let _e391 = select(0f, _e389, (_e389 > 0f));
let _e393 = select(_e190, _e391, (_e391 < _e190));
let _e400 = select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < -2147483600f)), 2147483647i, (_e393 > 2147483500f)), (_e393 == _e393));
let _e404 = (_e400 - select(0i, 1i, (_e393 < f32(_e400))));
let _e405 = ((_e381 - select(0i, 1i, (_e374 < f32(_e381)))) - _e404);
let _e414 = global_1.member.member_1[3u];
let _e418 = bitcast<u32>(((((((_e197 >> bitcast<u32>(_e178)) - bitcast<i32>(_e333)) * bitcast<i32>(_e286)) + (_e337 >> bitcast<u32>(_e178))) * bitcast<i32>(_e414)) + _e370));
if _e275 {
phi_726_ = -(_e404);
phi_727_ = -(_e405);
} else {
phi_726_ = _e404;
phi_727_ = _e405;
}
let _e422 = phi_726_;
let _e424 = phi_727_;
if (_e424 == 0i) {
} else {
if (_e418 < _e35) {
let _e430 = atomicAdd((&global_2.member[_e418]), bitcast<u32>(_e424));
}
}
if (_e422 == 0i) {
} else {
let _e432 = (_e418 + 1u);
if (_e432 < _e35) {
let _e437 = atomicAdd((&global_2.member[_e432]), bitcast<u32>(_e422));
}
}
phi_595_ = (_e337 + 1i);
} else {
phi_595_ = i32();
}
let _e440 = phi_595_;
continue;
continuing {
phi_594_ = _e440;
break if !(_e338);
}
}
}
phi_327_ = (_e197 + 1i);
} else {
phi_327_ = i32();
}
let _e444 = phi_327_;
continue;
continuing {
phi_326_ = _e444;
break if !(_e198);
}
}
}
}
return;
}
@compute @workgroup_size(8, 8, 1)
fn main(@builtin(global_invocation_id) param: vec3<u32>) {
global = param;
function_();
}
