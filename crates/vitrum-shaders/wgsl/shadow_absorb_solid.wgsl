struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_7 {
member: array<u32>,
}
struct type_8 {
member: type_2,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: type_4,
member_12: type_4,
member_13: f32,
}
struct type_9 {
member: type_8,
}
struct type_12 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(2)
var<storage, read_write> global_1: type_12;
@group(0) @binding(0)
var<storage> global_2: type_9;
@group(0) @binding(1)
var<storage> global_3: type_7;
fn function_() {
var phi_114_: i32;
var phi_117_: u32;
var phi_115_: i32;
var phi_118_: u32;
var local: u32;
var phi_229_: i32;
var phi_232_: u32;
var phi_267_: i32;
var phi_326_: u32;
var phi_391_: u32;
var phi_452_: u32;
var phi_230_: i32;
var phi_233_: u32;
let _e24 = global;
let _e26 = arrayLength((&global_3.member));
let _e28 = arrayLength((&global_1.member));
let _e31 = global_2.member.member;
if (_e24.x < _e31.member) {
if (_e24.y < _e31.member_1) {
let _e41 = global_2.member.member.member;
let _e43 = ((_e24.y * _e41) + _e24.x);
let _e46 = global_2.member.member_1;
if (_e43 < _e46) {
let _e50 = global_2.member.member_2;
let _e51 = bitcast<i32>(_e50);
let _e52 = bitcast<i32>(_e43);
let _e54 = (_e52 * (_e51 + 1i));
phi_114_ = 0i;
phi_117_ = 0u;
loop {
let _e56 = phi_114_;
let _e58 = phi_117_;
local = _e58;
let _e59 = (_e56 <= _e51);
if _e59 {
let _e60 = (_e54 + _e56);
let _e62 = (bitcast<i32>(_e26) - 1i);
let _e64 = select(_e62, _e60, (_e60 < _e62));
let _e70 = global_3.member[bitcast<u32>(select(0i, _e64, (_e64 > 0i)))];
phi_115_ = (_e56 + 1i);
phi_118_ = (_e58 + _e70);
} else {
phi_115_ = i32();
phi_118_ = u32();
}
let _e74 = phi_115_;
let _e76 = phi_118_;
continue;
continuing {
phi_114_ = _e74;
phi_117_ = _e76;
break if !(_e59);
}
}
let _e79 = local;
if (_e79 == 0u) {
let _e83 = global_2.member.member_3;
let _e84 = bitcast<i32>(_e83);
let _e88 = ((f32(_e52) + 0.5f) / f32(_e84));
let _e91 = global_2.member.member_4;
let _e93 = f32(bitcast<i32>(_e91));
let _e95 = select(0f, _e88, (_e88 > 0f));
let _e97 = select(_e93, _e95, (_e95 < _e93));
let _e104 = select(0i, select(select(i32(_e97), i32(-2147483648), (_e97 < -2147483600f)), 2147483647i, (_e97 > 2147483500f)), (_e97 == _e97));
let _e108 = (_e104 - select(0i, 1i, (_e97 < f32(_e104))));
let _e113 = global_2.member.member_5;
let _e123 = global_2.member.member_12.member;
let _e127 = global_2.member.member_12.member_2;
let _e129 = (_e123 + (_e127 * (f32((_e52 - (_e108 * _e84))) + 0.5f)));
let _e133 = global_2.member.member_12.member_1;
let _e135 = (_e133 + (_e127 * (f32((_e108 + bitcast<i32>(_e113))) + 0.5f)));
let _e139 = ((1f + (_e129 * _e129)) + (_e135 * _e135));
let _e145 = global_2.member.member_9;
let _e153 = global_2.member.member_8;
let _e154 = bitcast<i32>(_e153);
phi_229_ = 0i;
phi_232_ = 0u;
loop {
let _e156 = phi_229_;
let _e158 = phi_232_;
let _e159 = (_e156 < _e51);
if _e159 {
let _e160 = (_e54 + _e156);
let _e162 = (bitcast<i32>(_e26) - 1i);
let _e164 = select(_e162, _e160, (_e160 < _e162));
let _e170 = global_3.member[bitcast<u32>(select(0i, _e164, (_e164 > 0i)))];
let _e171 = (_e158 + _e170);
let _e172 = bitcast<i32>(_e171);
if (_e172 == 0i) {
} else {
if (_e172 < 0i) {
phi_267_ = -(_e172);
} else {
phi_267_ = _e172;
}
let _e177 = phi_267_;
let _e179 = (f32(_e177) * (1f / f32((1u << bitcast<u32>((_e145 & 31u))))));
let _e182 = (select(1f, _e179, (_e179 < 1f)) * sqrt(select(0f, _e139, (_e139 > 0f))));
let _e186 = ((((_e52 * _e51) + _e156) * _e154) * 2i);
let _e190 = global_2.member.member_11.member;
let _e193 = (((_e190 * _e182) * 16777216f) + 0.5f);
let _e195 = select(-1073741800f, _e193, (_e193 > -1073741800f));
let _e197 = select(1073741800f, _e195, (_e195 < 1073741800f));
let _e204 = select(0i, select(select(i32(_e197), i32(-2147483648), (_e197 < -2147483600f)), 2147483647i, (_e197 > 2147483500f)), (_e197 == _e197));
let _e208 = (_e204 - select(0i, 1i, (_e197 < f32(_e204))));
let _e209 = bitcast<u32>(_e208);
let _e212 = bitcast<u32>((_e208 >> bitcast<u32>(31i)));
if ((_e209 | _e212) == 0u) {
} else {
let _e215 = bitcast<u32>(_e186);
if (_e215 < _e28) {
let _e219 = atomicAdd((&global_1.member[_e215]), _e209);
phi_326_ = _e219;
} else {
phi_326_ = 0u;
}
let _e221 = phi_326_;
let _e225 = (_e212 + select(0u, 1u, ((_e221 + _e209) < _e209)));
if (_e225 == 0u) {
} else {
let _e227 = (_e215 + 1u);
if (_e227 < _e28) {
let _e231 = atomicAdd((&global_1.member[_e227]), _e225);
}
}
}
if (_e154 > 1i) {
let _e237 = global_2.member.member_11.member_1;
let _e240 = (((_e237 * _e182) * 16777216f) + 0.5f);
let _e242 = select(-1073741800f, _e240, (_e240 > -1073741800f));
let _e244 = select(1073741800f, _e242, (_e242 < 1073741800f));
let _e251 = select(0i, select(select(i32(_e244), i32(-2147483648), (_e244 < -2147483600f)), 2147483647i, (_e244 > 2147483500f)), (_e244 == _e244));
let _e255 = (_e251 - select(0i, 1i, (_e244 < f32(_e251))));
let _e256 = bitcast<u32>(_e255);
let _e259 = bitcast<u32>((_e255 >> bitcast<u32>(31i)));
if ((_e256 | _e259) == 0u) {
} else {
let _e262 = bitcast<u32>((_e186 + 2i));
if (_e262 < _e28) {
let _e266 = atomicAdd((&global_1.member[_e262]), _e256);
phi_391_ = _e266;
} else {
phi_391_ = 0u;
}
let _e268 = phi_391_;
let _e272 = (_e259 + select(0u, 1u, ((_e268 + _e256) < _e256)));
if (_e272 == 0u) {
} else {
let _e274 = (_e262 + 1u);
if (_e274 < _e28) {
let _e278 = atomicAdd((&global_1.member[_e274]), _e272);
}
}
}
let _e283 = global_2.member.member_11.member_2;
let _e286 = (((_e283 * _e182) * 16777216f) + 0.5f);
let _e288 = select(-1073741800f, _e286, (_e286 > -1073741800f));
let _e290 = select(1073741800f, _e288, (_e288 < 1073741800f));
let _e297 = select(0i, select(select(i32(_e290), i32(-2147483648), (_e290 < -2147483600f)), 2147483647i, (_e290 > 2147483500f)), (_e290 == _e290));
let _e301 = (_e297 - select(0i, 1i, (_e290 < f32(_e297))));
let _e302 = bitcast<u32>(_e301);
let _e305 = bitcast<u32>((_e301 >> bitcast<u32>(31i)));
if ((_e302 | _e305) == 0u) {
} else {
let _e308 = bitcast<u32>((_e186 + 4i));
if (_e308 < _e28) {
let _e312 = atomicAdd((&global_1.member[_e308]), _e302);
phi_452_ = _e312;
} else {
phi_452_ = 0u;
}
let _e314 = phi_452_;
let _e318 = (_e305 + select(0u, 1u, ((_e314 + _e302) < _e302)));
if (_e318 == 0u) {
} else {
let _e320 = (_e308 + 1u);
if (_e320 < _e28) {
let _e324 = atomicAdd((&global_1.member[_e320]), _e318);
}
}
}
}
}
phi_230_ = (_e156 + 1i);
phi_233_ = _e171;
} else {
phi_230_ = i32();
phi_233_ = u32();
}
let _e327 = phi_230_;
let _e329 = phi_233_;
continue;
continuing {
phi_229_ = _e327;
phi_232_ = _e329;
break if !(_e159);
}
}
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
