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
struct type_6 {
member: array<f32>,
}
struct type_9 {
member: array<u32>,
}
struct type_10 {
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
var phi_148_: i32;
var phi_367_: i32;
var phi_621_: i32;
var phi_702_: i32;
var phi_730_: u32;
var phi_703_: i32;
var phi_622_: i32;
var phi_368_: i32;
let _e31 = global;
let _e37 = arrayLength((&global_2.member));
let _e40 = global_1.member.member;
if (_e31.x < _e40.member) {
if (_e31.y < _e40.member_1) {
let _e50 = global_1.member.member.member;
let _e52 = ((_e31.y * _e50) + _e31.x);
let _e55 = global_1.member.member_1;
let _e57 = bitcast<i32>((_e52 * 3u));
let _e58 = (_e57 + 1i);
let _e60 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e62 = select(_e60, _e58, (_e58 < _e60));
let _e68 = global_3.member[bitcast<u32>(select(0i, _e62, (_e62 > 0i)))];
let _e69 = bitcast<i32>(_e68);
if (_e52 < _e55) {
let _e71 = (_e57 + 2i);
let _e73 = select(_e60, _e71, (_e71 < _e60));
let _e79 = global_3.member[bitcast<u32>(select(0i, _e73, (_e73 > 0i)))];
phi_148_ = bitcast<i32>(_e79);
} else {
phi_148_ = 0i;
}
let _e82 = phi_148_;
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
let _e204 = global_1.member.member_2;
let _e205 = bitcast<i32>(_e204);
let _e206 = f32(_e205);
let _e209 = global_1.member.member_3;
let _e210 = bitcast<i32>(_e209);
let _e214 = global_1.member.member_8;
let _e215 = bitcast<i32>(_e214);
phi_367_ = _e69;
loop {
let _e217 = phi_367_;
let _e218 = (_e217 < (_e69 + _e82));
if _e218 {
let _e220 = (f32(_e217) + 0.5f);
let _e221 = (_e121 <= _e220);
let _e222 = (_e148 > _e220);
let _e223 = (_e221 && _e222);
let _e224 = (_e148 <= _e220);
let _e225 = (_e121 > _e220);
let _e226 = (_e224 && _e225);
let _e227 = select(_e130, _e103, _e223);
let _e229 = select(_e139, _e112, _e223);
let _e231 = select(_e148, _e121, _e223);
let _e237 = ((_e220 - _e231) / select(1f, (select(_e121, _e148, _e223) - _e231), (_e223 || _e226)));
let _e240 = (_e227 + ((select(_e103, _e130, _e223) - _e227) * _e237));
let _e243 = (_e229 + ((select(_e112, _e139, _e223) - _e229) * _e237));
let _e244 = (_e175 > _e220);
let _e245 = (_e224 && _e244);
let _e246 = (_e175 <= _e220);
let _e247 = (_e246 && _e222);
let _e248 = select(_e157, _e130, _e245);
let _e250 = select(_e166, _e139, _e245);
let _e252 = select(_e175, _e148, _e245);
let _e258 = ((_e220 - _e252) / select(1f, (select(_e148, _e175, _e245) - _e252), (_e245 || _e247)));
let _e261 = (_e248 + ((select(_e130, _e157, _e245) - _e248) * _e258));
let _e264 = (_e250 + ((select(_e139, _e166, _e245) - _e250) * _e258));
let _e265 = (_e246 && _e225);
let _e267 = select(_e103, _e157, _e265);
let _e269 = select(_e112, _e166, _e265);
let _e271 = select(_e121, _e175, _e265);
let _e277 = ((_e220 - _e271) / select(1f, (select(_e175, _e121, _e265) - _e271), (_e265 || (_e221 && _e244))));
let _e280 = (_e267 + ((select(_e157, _e103, _e265) - _e267) * _e277));
let _e283 = (_e269 + ((select(_e166, _e112, _e265) - _e269) * _e277));
let _e287 = select(select(_e283, _e264, _e245), _e243, _e223);
let _e289 = select(select(_e280, _e261, _e247), _e240, _e226);
let _e291 = select(select(_e283, _e264, _e247), _e243, _e226);
if ((_e223 || _e245) || _e265) {
let _e304 = -(((select(_e291, _e287, (_e287 > _e291)) * 1f) - 0.5f));
let _e305 = -(f32(_e210));
let _e307 = select(_e305, _e304, (_e304 > _e305));
let _e309 = select(0f, _e307, (_e307 < 0f));
let _e316 = select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < -2147483600f)), 2147483647i, (_e309 > 2147483500f)), (_e309 == _e309));
let _e324 = -(((select(_e291, _e287, (_e287 < _e291)) * 1f) - 0.5f));
let _e326 = select(_e305, _e324, (_e324 > _e305));
let _e328 = select(0f, _e326, (_e326 < 0f));
let _e335 = select(0i, select(select(i32(_e328), i32(-2147483648), (_e328 < -2147483600f)), 2147483647i, (_e328 > 2147483500f)), (_e328 == _e328));
phi_621_ = -((_e335 - select(0i, 1i, (_e328 < f32(_e335)))));
loop {
let _e342 = phi_621_;
let _e343 = (_e342 < -((_e316 - select(0i, 1i, (_e309 < f32(_e316))))));
if _e343 {
let _e347 = (((f32(_e342) + 0.5f) - _e291) * (1f / select((_e287 - _e291), 1f, (_e287 == _e291))));
let _e349 = select(0f, _e347, (_e347 > 0f));
let _e354 = (_e289 + ((select(select(_e280, _e261, _e245), _e240, _e223) - _e289) * select(1f, _e349, (_e349 < 1f))));
let _e357 = global_1.member.member_13;
let _e361 = (_e354 / (1f + (_e357 * (_e206 - _e354))));
let _e363 = select(0f, _e361, (_e361 > 0f));
let _e365 = select(_e206, _e363, (_e363 < _e206));
let _e366 = (_e206 - 1f);
let _e368 = select(0f, _e365, (_e365 > 0f));
let _e370 = select(_e366, _e368, (_e368 < _e366));
let _e377 = select(0i, select(select(i32(_e370), i32(-2147483648), (_e370 < -2147483600f)), 2147483647i, (_e370 > 2147483500f)), (_e370 == _e370));
let _e384 = global_1.member.member_5;
phi_702_ = 0i;
loop {
let _e392 = phi_702_;
let _e393 = (_e392 < _e215);
if _e393 {
let _e397 = bitcast<u32>(_e201);
let _e400 = bitcast<u32>((_e201 >> bitcast<u32>(31i)));
if ((_e397 | _e400) == 0u) {
} else {
let _e403 = bitcast<u32>(((((((((_e217 - bitcast<i32>(_e384)) * _e210) + _e342) * _e205) + (_e377 - select(0i, 1i, (_e370 < f32(_e377))))) * _e215) + _e392) * 2i));
if (_e403 < _e37) {
let _e407 = atomicAdd((&global_2.member[_e403]), _e397);
phi_730_ = _e407;
} else {
phi_730_ = 0u;
}
let _e409 = phi_730_;
let _e413 = (_e400 + select(0u, 1u, ((_e409 + _e397) < _e397)));
if (_e413 == 0u) {
} else {
let _e415 = (_e403 + 1u);
if (_e415 < _e37) {
let _e419 = atomicAdd((&global_2.member[_e415]), _e413);
}
}
}
phi_703_ = (_e392 + 1i);
} else {
phi_703_ = i32();
}
let _e422 = phi_703_;
continue;
continuing {
phi_702_ = _e422;
break if !(_e393);
}
}
phi_622_ = (_e342 + 1i);
} else {
phi_622_ = i32();
}
let _e426 = phi_622_;
continue;
continuing {
phi_621_ = _e426;
break if !(_e343);
}
}
}
phi_368_ = (_e217 + 1i);
} else {
phi_368_ = i32();
}
let _e430 = phi_368_;
continue;
continuing {
phi_367_ = _e430;
break if !(_e218);
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
