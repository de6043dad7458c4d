struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: f32,
}
struct type_6 {
member: array<f32>,
}
struct type_9 {
member: array<u32>,
}
struct type_10 {
member: vec4<u32>,
member_1: vec4<u32>,
member_2: vec4<u32>,
member_3: type_4,
}
struct type_11 {
member: type_10,
}
struct type_14 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_11;
@group(0) @binding(3)
var<storage, read_write> global_2: type_14;
@group(0) @binding(2)
var<storage> global_3: type_9;
@group(0) @binding(1)
var<storage> global_4: type_6;
fn function_() {
var phi_149_: i32;
var phi_371_: i32;
var phi_625_: i32;
var phi_703_: i32;
var phi_728_: u32;
var phi_704_: i32;
var phi_626_: i32;
var phi_372_: i32;
let _e31 = global;
let _e37 = arrayLength((&global_2.member));
let _e41 = global_1.member.member[0u];
let _e45 = global_1.member.member[1u];
if (_e31.x < _e41) {
if (_e31.y < _e45) {
let _e51 = ((_e31.y * _e41) + _e31.x);
let _e55 = global_1.member.member[3u];
let _e57 = bitcast<i32>((_e51 * 3u));
let _e58 = (_e57 + 1i);
let _e60 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e62 = select(_e60, _e58, (_e58 < _e60));
let _e68 = global_3.member[bitcast<u32>(select(0i, _e62, (_e62 > 0i)))];
let _e69 = bitcast<i32>(_e68);
if (_e51 < _e55) {
let _e71 = (_e57 + 2i);
let _e73 = select(_e60, _e71, (_e71 < _e60));
let _e79 = global_3.member[bitcast<u32>(select(0i, _e73, (_e73 > 0i)))];
phi_149_ = bitcast<i32>(_e79);
} else {
phi_149_ = 0i;
}
let _e82 = phi_149_;
let _e84 = select(_e60, _e57, (_e57 < _e60));
let _e90 = global_3.member[bitcast<u32>(select(0i, _e84, (_e84 > 0i)))];
let _e93 = (bitcast<i32>(_e90) * 10i);
let _e95 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e97 = select(_e95, _e93, (_e93 < _e95));
let _e103 = global_4.member[bitcast<u32>(select(0i, _e97, (_e97 > 0i)))];
let _e104 = (_e93 + 1i);
let _e106 = select(_e95, _e104, (_e104 < _e95));
let _e112 = global_4.member[bitcast<u32>(select(0i, _e106, (_e106 > 0i)))];
let _e113 = (_e93 + 2i);
let _e115 = select(_e95, _e113, (_e113 < _e95));
let _e121 = global_4.member[bitcast<u32>(select(0i, _e115, (_e115 > 0i)))];
let _e122 = (_e93 + 3i);
let _e124 = select(_e95, _e122, (_e122 < _e95));
let _e130 = global_4.member[bitcast<u32>(select(0i, _e124, (_e124 > 0i)))];
let _e131 = (_e93 + 4i);
let _e133 = select(_e95, _e131, (_e131 < _e95));
let _e139 = global_4.member[bitcast<u32>(select(0i, _e133, (_e133 > 0i)))];
let _e140 = (_e93 + 5i);
let _e142 = select(_e95, _e140, (_e140 < _e95));
let _e148 = global_4.member[bitcast<u32>(select(0i, _e142, (_e142 > 0i)))];
let _e149 = (_e93 + 6i);
let _e151 = select(_e95, _e149, (_e149 < _e95));
let _e157 = global_4.member[bitcast<u32>(select(0i, _e151, (_e151 > 0i)))];
let _e158 = (_e93 + 7i);
let _e160 = select(_e95, _e158, (_e158 < _e95));
let _e166 = global_4.member[bitcast<u32>(select(0i, _e160, (_e160 > 0i)))];
let _e167 = (_e93 + 8i);
let _e169 = select(_e95, _e167, (_e167 < _e95));
let _e175 = global_4.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e176 = (_e93 + 9i);
let _e178 = select(_e95, _e176, (_e176 < _e95));
let _e184 = global_4.member[bitcast<u32>(select(0i, _e178, (_e178 > 0i)))];
let _e186 = ((_e184 * 16777216f) + 0.5f);
let _e188 = select(-1073741800f, _e186, (_e186 > -1073741800f));
let _e190 = select(1073741800f, _e188, (_e188 < 1073741800f));
let _e197 = select(0i, select(select(i32(_e190), i32(-2147483648), (_e190 < -2147483600f)), 2147483647i, (_e190 > 2147483500f)), (_e190 == _e190));
let _e201 = (_e197 - select(0i, 1i, (_e190 < f32(_e197))));
let _e205 = global_1.member.member_1[0u];
let _e206 = bitcast<i32>(_e205);
let _e207 = f32(_e206);
let _e211 = global_1.member.member_1[1u];
let _e212 = bitcast<i32>(_e211);
let _e217 = global_1.member.member_2[0u];
let _e218 = bitcast<i32>(_e217);
phi_371_ = _e69;
loop {
let _e220 = phi_371_;
let _e221 = (_e220 < (_e69 + _e82));
if _e221 {
let _e223 = (f32(_e220) + 0.5f);
let _e224 = (_e121 <= _e223);
let _e225 = (_e148 > _e223);
let _e226 = (_e224 && _e225);
let _e227 = (_e148 <= _e223);
let _e228 = (_e121 > _e223);
let _e229 = (_e227 && _e228);
let _e230 = select(_e130, _e103, _e226);
let _e232 = select(_e139, _e112, _e226);
let _e234 = select(_e148, _e121, _e226);
let _e240 = ((_e223 - _e234) / select(1f, (select(_e121, _e148, _e226) - _e234), (_e226 || _e229)));
let _e243 = (_e230 + ((select(_e103, _e130, _e226) - _e230) * _e240));
let _e246 = (_e232 + ((select(_e112, _e139, _e226) - _e232) * _e240));
let _e247 = (_e175 > _e223);
let _e248 = (_e227 && _e247);
let _e249 = (_e175 <= _e223);
let _e250 = (_e249 && _e225);
let _e251 = select(_e157, _e130, _e248);
let _e253 = select(_e166, _e139, _e248);
let _e255 = select(_e175, _e148, _e248);
let _e261 = ((_e223 - _e255) / select(1f, (select(_e148, _e175, _e248) - _e255), (_e248 || _e250)));
let _e264 = (_e251 + ((select(_e130, _e157, _e248) - _e251) * _e261));
let _e267 = (_e253 + ((select(_e139, _e166, _e248) - _e253) * _e261));
let _e268 = (_e249 && _e228);
let _e270 = select(_e103, _e157, _e268);
let _e272 = select(_e112, _e166, _e268);
let _e274 = select(_e121, _e175, _e268);
let _e280 = ((_e223 - _e274) / select(1f, (select(_e175, _e121, _e268) - _e274), (_e268 || (_e224 && _e247))));
let _e283 = (_e270 + ((select(_e157, _e103, _e268) - _e270) * _e280));
let _e286 = (_e272 + ((select(_e166, _e112, _e268) - _e272) * _e280));
let _e290 = select(select(_e286, _e267, _e248), _e246, _e226);
let _e292 = select(select(_e283, _e264, _e250), _e243, _e229);
let _e294 = select(select(_e286, _e267, _e250), _e246, _e229);
if ((_e226 || _e248) || _e268) {
let _e307 = -(((select(_e294, _e290, (_e290 > _e294)) * 1f) - 0.5f));
let _e308 = -(f32(_e212));
let _e310 = select(_e308, _e307, (_e307 > _e308));
let _e312 = select(0f, _e310, (_e310 < 0f));
let _e319 = select(0i, select(select(i32(_e312), i32(-2147483648), (_e312 < -2147483600f)), 2147483647i, (_e312 > 2147483500f)), (_e312 == _e312));
let _e327 = -(((select(_e294, _e290, (_e290 < _e294)) * 1f) - 0.5f));
let _e329 = select(_e308, _e327, (_e327 > _e308));
let _e331 = select(0f, _e329, (_e329 < 0f));
let _e338 = select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < -2147483600f)), 2147483647i, (_e331 > 2147483500f)), (_e331 == _e331));
phi_625_ = -((_e338 - select(0i, 1i, (_e331 < f32(_e338)))));
loop {
let _e345 = phi_625_;
let _e346 = (_e345 < -((_e319 - select(0i, 1i, (_e312 < f32(_e319))))));
if _e346 {
let _e350 = (((f32(_e345) + 0.5f) - _e294) * (1f / select((_e290 - _e294), 1f, (_e290 == _e294))));
let _e352 = select(0f, _e350, (_e350 > 0f));
let _e357 = (_e292 + ((select(select(_e283, _e264, _e248), _e243, _e226) - _e292) * select(1f, _e352, (_e352 < 1f))));
let _e359 = select(0f, _e357, (_e357 > 0f));
let _e361 = select(_e207, _e359, (_e359 < _e207));
let _e362 = (_e207 - 1f);
let _e364 = select(0f, _e361, (_e361 > 0f));
let _e366 = select(_e362, _e364, (_e364 < _e362));
let _e373 = select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < -2147483600f)), 2147483647i, (_e366 > 2147483500f)), (_e366 == _e366));
let _e381 = global_1.member.member_1[3u];
phi_703_ = 0i;
loop {
let _e389 = phi_703_;
let _e390 = (_e389 < _e218);
if _e390 {
if (_e201 == 0i) {
} else {
let _e395 = bitcast<u32>(_e201);
let _e396 = bitcast<u32>(((((((((_e220 - bitcast<i32>(_e381)) * _e212) + _e345) * _e206) + (_e373 - select(0i, 1i, (_e366 < f32(_e373))))) * _e218) + _e389) * 2i));
if (_e396 < _e37) {
let _e400 = atomicAdd((&global_2.member[_e396]), _e395);
phi_728_ = _e400;
} else {
phi_728_ = 0u;
}
let _e402 = phi_728_;
let _e409 = (bitcast<u32>((_e201 >> bitcast<u32>(31i))) + select(0u, 1u, ((_e402 + _e395) < _e395)));
if (_e409 == 0u) {
} else {
let _e411 = (_e396 + 1u);
if (_e411 < _e37) {
let _e415 = atomicAdd((&global_2.member[_e411]), _e409);
}
}
}
phi_704_ = (_e389 + 1i);
} else {
phi_704_ = i32();
}
let _e418 = phi_704_;
continue;
continuing {
phi_703_ = _e418;
break if !(_e390);
}
}
phi_626_ = (_e345 + 1i);
} else {
phi_626_ = i32();
}
let _e422 = phi_626_;
continue;
continuing {
phi_625_ = _e422;
break if !(_e346);
}
}
}
phi_372_ = (_e220 + 1i);
} else {
phi_372_ = i32();
}
let _e426 = phi_372_;
continue;
continuing {
phi_371_ = _e426;
break if !(_e221);
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
