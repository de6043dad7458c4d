struct type_2 {
member: u32,
member_1: u32,
member_2: u32,
}
struct type_4 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
}
struct type_5 {
member: f32,
member_1: f32,
member_2: f32,
}
struct type_6 {
member: u32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: f32,
member_11: f32,
member_12: f32,
}
struct type_7 {
member: type_5,
member_1: f32,
}
struct type_8 {
member: type_7,
member_1: type_5,
}
struct type_9 {
member: type_8,
member_1: type_8,
}
struct type_10 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: f32,
member_4: u32,
member_5: u32,
member_6: u32,
}
struct type_11 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_10,
}
struct type_12 {
member: type_2,
member_1: u32,
member_2: type_5,
member_3: type_7,
member_4: type_7,
member_5: type_7,
member_6: type_7,
member_7: type_5,
member_8: f32,
member_9: f32,
}
struct type_13 {
member: type_2,
member_1: u32,
member_2: type_2,
member_3: u32,
member_4: type_2,
member_5: u32,
member_6: type_4,
member_7: type_5,
member_8: type_5,
member_9: type_5,
member_10: type_5,
member_11: f32,
member_12: f32,
member_13: f32,
member_14: type_5,
member_15: type_5,
member_16: type_6,
member_17: type_9,
member_18: type_11,
member_19: type_5,
member_20: type_12,
}
struct type_14 {
member: type_13,
}
struct type_16 {
member: array<f32>,
}
struct type_20 {
member: vec3<f32>,
member_1: vec3<f32>,
member_2: vec3<f32>,
member_3: vec3<f32>,
member_4: vec3<f32>,
member_5: f32,
member_6: f32,
member_7: i32,
member_8: f32,
member_9: f32,
member_10: f32,
member_11: f32,
member_12: i32,
member_13: i32,
member_14: f32,
}
struct type_22 {
member: array<u32>,
}
struct type_25 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_14;
@group(0) @binding(3)
var<storage> global_2: type_16;
@group(0) @binding(4)
var<storage, read_write> global_3: type_16;
@group(0) @binding(1)
var<storage> global_4: type_22;
@group(0) @binding(2)
var<storage> global_5: type_22;
@group(0) @binding(5)
var<storage, read_write> global_6: type_25;
fn function_() {
var local: i32;
var local_1: vec3<f32>;
var phi_654_: u32;
var phi_739_: i32;
var phi_742_: i32;
var phi_1178_: f32;
var phi_740_: i32;
var phi_743_: i32;
var local_2: i32;
var phi_1186_: type_20;
var phi_1188_: type_20;
var phi_1191_: i32;
var phi_1527_: f32;
var phi_1565_: i32;
var phi_1568_: i32;
var phi_2004_: f32;
var phi_1566_: i32;
var phi_1569_: i32;
var local_3: i32;
var phi_2016_: i32;
var phi_2019_: f32;
var phi_2021_: f32;
var phi_2050_: i32;
var phi_2053_: i32;
var phi_2489_: f32;
var phi_2051_: i32;
var phi_2054_: i32;
var local_4: i32;
var phi_2017_: i32;
var phi_2020_: f32;
var phi_2022_: f32;
var local_5: f32;
var local_6: f32;
var local_7: f32;
var phi_2524_: i32;
var phi_2527_: i32;
var phi_2963_: f32;
var phi_2525_: i32;
var phi_2528_: i32;
var local_8: i32;
var local_9: i32;
var phi_3423_: f32;
var phi_3862_: f32;
var phi_4302_: f32;
var phi_4741_: f32;
var phi_5181_: f32;
var phi_5620_: f32;
var local_10: f32;
var local_11: i32;
var local_12: f32;
var local_13: f32;
var local_14: f32;
var local_15: f32;
var local_16: f32;
var phi_5950_: type_20;
var local_17: i32;
var local_18: i32;
var phi_6161_: type_20;
var phi_6214_: type_20;
var phi_6228_: type_20;
var local_19: i32;
var phi_6672_: type_20;
var phi_6673_: type_20;
var phi_6653_: type_20;
var phi_6674_: type_20;
var local_20: i32;
var phi_6683_: type_20;
var phi_6684_: type_20;
var phi_6685_: bool;
var phi_7264_: type_20;
var local_21: i32;
var phi_7566_: type_20;
var phi_7567_: type_20;
var phi_7568_: type_20;
var phi_6975_: type_20;
var phi_7569_: type_20;
var phi_1189_: type_20;
var phi_1192_: i32;
var local_22: type_20;
var local_23: type_20;
var local_24: type_20;
var local_25: type_20;
var local_26: type_20;
var local_27: type_20;
var local_28: type_20;
var local_29: type_20;
var local_30: type_20;
var local_31: type_20;
var local_32: type_20;
var local_33: type_20;
var local_34: type_20;
var local_35: type_20;
var local_36: type_20;
var local_37: type_20;
var local_38: type_20;
var local_39: type_20;
var local_40: type_20;
var local_41: type_20;
var local_42: type_20;
var local_43: type_20;
var local_44: type_20;
var local_45: type_20;
var local_46: f32;
let _e86 = global;
let _e92 = arrayLength((&global_5.member));
let _e94 = arrayLength((&global_2.member));
let _e101 = global_1.member.member;
if (_e86.x < _e101.member) {
if (_e86.y < _e101.member_1) {
let _e108 = (_e101.member * _e101.member_1);
let _e110 = ((_e86.y * _e101.member) + _e86.x);
let _e111 = bitcast<i32>(_e110);
let _e113 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e115 = select(_e113, _e111, (_e111 < _e113));
let _e121 = global_3.member[bitcast<u32>(select(0i, _e115, (_e115 > 0i)))];
let _e122 = (_e108 + _e110);
let _e123 = bitcast<i32>(_e122);
let _e125 = select(_e113, _e123, (_e123 < _e113));
let _e131 = global_3.member[bitcast<u32>(select(0i, _e125, (_e125 > 0i)))];
let _e133 = ((2u * _e108) + _e110);
let _e134 = bitcast<i32>(_e133);
let _e136 = select(_e113, _e134, (_e134 < _e113));
let _e142 = global_3.member[bitcast<u32>(select(0i, _e136, (_e136 > 0i)))];
let _e144 = ((3u * _e108) + _e110);
let _e145 = bitcast<i32>(_e144);
let _e147 = select(_e113, _e145, (_e145 < _e113));
let _e153 = global_3.member[bitcast<u32>(select(0i, _e147, (_e147 > 0i)))];
let _e155 = ((4u * _e108) + _e110);
let _e156 = bitcast<i32>(_e155);
let _e158 = select(_e113, _e156, (_e156 < _e113));
let _e164 = global_3.member[bitcast<u32>(select(0i, _e158, (_e158 > 0i)))];
let _e166 = ((5u * _e108) + _e110);
let _e167 = bitcast<i32>(_e166);
let _e169 = select(_e113, _e167, (_e167 < _e113));
let _e175 = global_3.member[bitcast<u32>(select(0i, _e169, (_e169 > 0i)))];
let _e177 = ((6u * _e108) + _e110);
let _e178 = bitcast<i32>(_e177);
let _e180 = select(_e113, _e178, (_e178 < _e113));
let _e186 = global_3.member[bitcast<u32>(select(0i, _e180, (_e180 > 0i)))];
let _e188 = ((7u * _e108) + _e110);
let _e189 = bitcast<i32>(_e188);
let _e191 = select(_e113, _e189, (_e189 < _e113));
let _e197 = global_3.member[bitcast<u32>(select(0i, _e191, (_e191 > 0i)))];
let _e199 = ((8u * _e108) + _e110);
let _e200 = bitcast<i32>(_e199);
let _e202 = select(_e113, _e200, (_e200 < _e113));
let _e208 = global_3.member[bitcast<u32>(select(0i, _e202, (_e202 > 0i)))];
let _e210 = ((9u * _e108) + _e110);
let _e211 = bitcast<i32>(_e210);
let _e213 = select(_e113, _e211, (_e211 < _e113));
let _e219 = global_3.member[bitcast<u32>(select(0i, _e213, (_e213 > 0i)))];
let _e221 = ((10u * _e108) + _e110);
let _e222 = bitcast<i32>(_e221);
let _e224 = select(_e113, _e222, (_e222 < _e113));
let _e230 = global_3.member[bitcast<u32>(select(0i, _e224, (_e224 > 0i)))];
let _e232 = ((11u * _e108) + _e110);
let _e233 = bitcast<i32>(_e232);
let _e235 = select(_e113, _e233, (_e233 < _e113));
let _e241 = global_3.member[bitcast<u32>(select(0i, _e235, (_e235 > 0i)))];
let _e243 = ((12u * _e108) + _e110);
let _e244 = bitcast<i32>(_e243);
let _e246 = select(_e113, _e244, (_e244 < _e113));
let _e252 = global_3.member[bitcast<u32>(select(0i, _e246, (_e246 > 0i)))];
let _e254 = ((13u * _e108) + _e110);
let _e255 = bitcast<i32>(_e254);
let _e257 = select(_e113, _e255, (_e255 < _e113));
let _e263 = global_3.member[bitcast<u32>(select(0i, _e257, (_e257 > 0i)))];
let _e265 = ((14u * _e108) + _e110);
let _e266 = bitcast<i32>(_e265);
let _e268 = select(_e113, _e266, (_e266 < _e113));
let _e274 = global_3.member[bitcast<u32>(select(0i, _e268, (_e268 > 0i)))];
let _e276 = ((15u * _e108) + _e110);
let _e277 = bitcast<i32>(_e276);
let _e279 = select(_e113, _e277, (_e277 < _e113));
let _e285 = global_3.member[bitcast<u32>(select(0i, _e279, (_e279 > 0i)))];
let _e287 = ((16u * _e108) + _e110);
let _e288 = bitcast<i32>(_e287);
let _e290 = select(_e113, _e288, (_e288 < _e113));
let _e296 = global_3.member[bitcast<u32>(select(0i, _e290, (_e290 > 0i)))];
let _e298 = ((17u * _e108) + _e110);
let _e299 = bitcast<i32>(_e298);
let _e301 = select(_e113, _e299, (_e299 < _e113));
let _e307 = global_3.member[bitcast<u32>(select(0i, _e301, (_e301 > 0i)))];
let _e309 = ((18u * _e108) + _e110);
let _e310 = bitcast<i32>(_e309);
let _e312 = select(_e113, _e310, (_e310 < _e113));
let _e318 = global_3.member[bitcast<u32>(select(0i, _e312, (_e312 > 0i)))];
let _e320 = ((19u * _e108) + _e110);
let _e321 = bitcast<i32>(_e320);
let _e323 = select(_e113, _e321, (_e321 < _e113));
let _e329 = global_3.member[bitcast<u32>(select(0i, _e323, (_e323 > 0i)))];
let _e331 = ((20u * _e108) + _e110);
let _e332 = bitcast<i32>(_e331);
let _e334 = select(_e113, _e332, (_e332 < _e113));
let _e340 = global_3.member[bitcast<u32>(select(0i, _e334, (_e334 > 0i)))];
let _e342 = ((21u * _e108) + _e110);
let _e343 = bitcast<i32>(_e342);
let _e345 = select(_e113, _e343, (_e343 < _e113));
let _e351 = global_3.member[bitcast<u32>(select(0i, _e345, (_e345 > 0i)))];
let _e353 = ((22u * _e108) + _e110);
let _e354 = bitcast<i32>(_e353);
let _e356 = select(_e113, _e354, (_e354 < _e113));
let _e362 = global_3.member[bitcast<u32>(select(0i, _e356, (_e356 > 0i)))];
let _e364 = ((23u * _e108) + _e110);
let _e365 = bitcast<i32>(_e364);
let _e367 = select(_e113, _e365, (_e365 < _e113));
let _e373 = global_3.member[bitcast<u32>(select(0i, _e367, (_e367 > 0i)))];
let _e375 = ((24u * _e108) + _e110);
let _e376 = bitcast<i32>(_e375);
let _e378 = select(_e113, _e376, (_e376 < _e113));
let _e384 = global_3.member[bitcast<u32>(select(0i, _e378, (_e378 > 0i)))];
let _e385 = (_e296 == 0f);
if _e385 {
phi_654_ = 3u;
} else {
phi_654_ = select(0u, 1u, (_e296 == 4f));
}
let _e389 = phi_654_;
if (_e389 > 0u) {
if (arrayLength((&global_6.member)) >= 3u) {
let _e398 = atomicLoad((&global_6.member[0u]));
if (_e398 == 0u) {
atomicStore((&global_6.member[0u]), ((_e101.member + 7u) / 8u));
atomicStore((&global_6.member[1u]), ((_e101.member_1 + 7u) / 8u));
atomicStore((&global_6.member[2u]), 1u);
}
}
}
if (_e389 > 1u) {
let _e406 = vec3<f32>(_e121, _e131, _e142);
let _e407 = vec3<f32>(_e153, _e164, _e175);
let _e408 = vec3<f32>(_e186, _e197, _e208);
let _e409 = vec3<f32>(_e219, _e230, _e241);
let _e410 = vec3<f32>(_e252, _e263, _e274);
let _e424 = select(0i, select(select(i32(_e362), i32(-2147483648), (_e362 < -2147483600f)), 2147483647i, (_e362 > 2147483500f)), (_e362 == _e362));
let _e431 = select(0i, select(select(i32(_e373), i32(-2147483648), (_e373 < -2147483600f)), 2147483647i, (_e373 > 2147483500f)), (_e373 == _e373));
let _e435 = global_1.member.member_14;
let _e441 = global_1.member.member_15;
if (_e385 && (_e318 == 0f)) {
let _e449 = global_1.member.member_3;
phi_739_ = (bitcast<i32>(_e449) - 1i);
phi_742_ = 16i;
loop {
let _e453 = phi_739_;
let _e455 = phi_742_;
local_2 = _e455;
let _e456 = (_e453 >= 0i);
if _e456 {
let _e460 = global_1.member.member_2.member;
let _e465 = global_1.member.member_2.member_1;
let _e470 = global_1.member.member_2.member_2;
let _e472 = (_e121 - 0.5f);
let _e473 = (_e131 - 0.5f);
let _e474 = (_e142 - 0.5f);
let _e476 = f32((bitcast<i32>(_e460) - 2i));
let _e478 = select(0f, _e472, (_e472 > 0f));
let _e480 = select(_e476, _e478, (_e478 < _e476));
let _e487 = select(0i, select(select(i32(_e480), i32(-2147483648), (_e480 < -2147483600f)), 2147483647i, (_e480 > 2147483500f)), (_e480 == _e480));
let _e491 = (_e487 - select(0i, 1i, (_e480 < f32(_e487))));
let _e493 = f32((bitcast<i32>(_e465) - 2i));
let _e495 = select(0f, _e473, (_e473 > 0f));
let _e497 = select(_e493, _e495, (_e495 < _e493));
let _e504 = select(0i, select(select(i32(_e497), i32(-2147483648), (_e497 < -2147483600f)), 2147483647i, (_e497 > 2147483500f)), (_e497 == _e497));
let _e508 = (_e504 - select(0i, 1i, (_e497 < f32(_e504))));
let _e510 = f32((bitcast<i32>(_e470) - 2i));
let _e512 = select(0f, _e474, (_e474 > 0f));
let _e514 = select(_e510, _e512, (_e512 < _e510));
let _e521 = select(0i, select(select(i32(_e514), i32(-2147483648), (_e514 < -2147483600f)), 2147483647i, (_e514 > 2147483500f)), (_e514 == _e514));
let _e525 = (_e521 - select(0i, 1i, (_e514 < f32(_e521))));
let _e526 = (_e453 * 4i);
let _e527 = (_e526 + 1i);
let _e529 = (bitcast<i32>(_e92) - 1i);
let _e531 = select(_e529, _e527, (_e527 < _e529));
let _e537 = global_5.member[bitcast<u32>(select(0i, _e531, (_e531 > 0i)))];
let _e538 = (_e526 + 2i);
let _e540 = select(_e529, _e538, (_e538 < _e529));
let _e546 = global_5.member[bitcast<u32>(select(0i, _e540, (_e540 > 0i)))];
let _e547 = (_e526 + 3i);
let _e549 = select(_e529, _e547, (_e547 < _e529));
let _e555 = global_5.member[bitcast<u32>(select(0i, _e549, (_e549 > 0i)))];
let _e558 = (_e491 - bitcast<i32>((_e537 & 65535u)));
let _e563 = bitcast<i32>((_e537 >> bitcast<u32>(16i)));
let _e568 = (_e508 - bitcast<i32>((_e546 & 65535u)));
let _e573 = bitcast<i32>((_e546 >> bitcast<u32>(16i)));
let _e578 = (_e525 - bitcast<i32>((_e555 & 65535u)));
if ((((_e558 >= 0i) && ((_e558 + 1i) < _e563)) && ((_e568 >= 0i) && ((_e568 + 1i) < _e573))) && ((_e578 >= 0i) && ((_e578 + 1i) < bitcast<i32>((_e555 >> bitcast<u32>(16i)))))) {
let _e588 = (_e573 * _e563);
let _e590 = select(_e529, _e526, (_e526 < _e529));
let _e596 = global_5.member[bitcast<u32>(select(0i, _e590, (_e590 > 0i)))];
let _e602 = (((bitcast<i32>(_e596) + (_e578 * _e588)) + (_e568 * _e563)) + _e558);
let _e604 = (_e472 - f32(_e491));
let _e606 = (_e473 - f32(_e508));
let _e609 = (2i * _e602);
let _e611 = (_e609 >> bitcast<u32>(2i));
let _e614 = bitcast<u32>(((_e609 & 3i) * 8i));
let _e616 = select(_e529, _e611, (_e611 < _e529));
let _e622 = global_5.member[bitcast<u32>(select(0i, _e616, (_e616 > 0i)))];
let _e626 = (_e611 + 1i);
let _e628 = select(_e529, _e626, (_e626 < _e529));
let _e634 = global_5.member[bitcast<u32>(select(0i, _e628, (_e628 > 0i)))];
let _e641 = ((_e622 >> bitcast<u32>((_e614 & 31u))) | ((_e634 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e614) & 31u))));
let _e644 = f32(bitcast<i32>((_e641 & 65535u)));
let _e651 = (_e644 + ((f32(bitcast<i32>((_e641 >> bitcast<u32>(16i)))) - _e644) * _e604));
let _e653 = (2i * (_e602 + _e563));
let _e655 = (_e653 >> bitcast<u32>(2i));
let _e658 = bitcast<u32>(((_e653 & 3i) * 8i));
let _e660 = select(_e529, _e655, (_e655 < _e529));
let _e666 = global_5.member[bitcast<u32>(select(0i, _e660, (_e660 > 0i)))];
let _e670 = (_e655 + 1i);
let _e672 = select(_e529, _e670, (_e670 < _e529));
let _e678 = global_5.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e685 = ((_e666 >> bitcast<u32>((_e658 & 31u))) | ((_e678 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e658) & 31u))));
let _e688 = f32(bitcast<i32>((_e685 & 65535u)));
let _e696 = (_e602 + _e588);
let _e697 = (2i * _e696);
let _e699 = (_e697 >> bitcast<u32>(2i));
let _e702 = bitcast<u32>(((_e697 & 3i) * 8i));
let _e704 = select(_e529, _e699, (_e699 < _e529));
let _e710 = global_5.member[bitcast<u32>(select(0i, _e704, (_e704 > 0i)))];
let _e714 = (_e699 + 1i);
let _e716 = select(_e529, _e714, (_e714 < _e529));
let _e722 = global_5.member[bitcast<u32>(select(0i, _e716, (_e716 > 0i)))];
let _e729 = ((_e710 >> bitcast<u32>((_e702 & 31u))) | ((_e722 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e702) & 31u))));
let _e732 = f32(bitcast<i32>((_e729 & 65535u)));
let _e739 = (_e732 + ((f32(bitcast<i32>((_e729 >> bitcast<u32>(16i)))) - _e732) * _e604));
let _e741 = (2i * (_e696 + _e563));
let _e743 = (_e741 >> bitcast<u32>(2i));
let _e746 = bitcast<u32>(((_e741 & 3i) * 8i));
let _e748 = select(_e529, _e743, (_e743 < _e529));
let _e754 = global_5.member[bitcast<u32>(select(0i, _e748, (_e748 > 0i)))];
let _e758 = (_e743 + 1i);
let _e760 = select(_e529, _e758, (_e758 < _e529));
let _e766 = global_5.member[bitcast<u32>(select(0i, _e760, (_e760 > 0i)))];
let _e773 = ((_e754 >> bitcast<u32>((_e746 & 31u))) | ((_e766 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e746) & 31u))));
let _e776 = f32(bitcast<i32>((_e773 & 65535u)));
let _e786 = (_e651 + (((_e688 + ((f32(bitcast<i32>((_e685 >> bitcast<u32>(16i)))) - _e688) * _e604)) - _e651) * _e606));
phi_1178_ = (_e786 + (((_e739 + (((_e776 + ((f32(bitcast<i32>((_e773 >> bitcast<u32>(16i)))) - _e776) * _e604)) - _e739) * _e606)) - _e786) * (_e474 - f32(_e525))));
} else {
phi_1178_ = 0f;
}
let _e794 = phi_1178_;
phi_740_ = (_e453 - 1i);
phi_743_ = select(_e455, _e453, (_e794 > 32767.5f));
} else {
phi_740_ = i32();
phi_743_ = i32();
}
let _e799 = phi_740_;
let _e801 = phi_743_;
continue;
continuing {
phi_739_ = _e799;
phi_742_ = _e801;
break if !(_e456);
}
}
let _e804 = local_2;
phi_1186_ = type_20(_e406, _e407, _e408, _e409, _e410, _e285, _e296, _e804, _e318, _e329, _e340, _e351, _e424, _e431, _e384);
} else {
phi_1186_ = type_20(_e406, _e407, _e408, _e409, _e410, _e285, _e296, select(0i, select(select(i32(_e307), i32(-2147483648), (_e307 < -2147483600f)), 2147483647i, (_e307 > 2147483500f)), (_e307 == _e307)), _e318, _e329, _e340, _e351, _e424, _e431, _e384);
}
let _e807 = phi_1186_;
phi_1188_ = _e807;
phi_1191_ = 0i;
loop {
let _e809 = phi_1188_;
let _e811 = phi_1191_;
local_22 = _e809;
local_23 = _e809;
local_24 = _e809;
local_25 = _e809;
local_26 = _e809;
local_27 = _e809;
local_28 = _e809;
local_29 = _e809;
local_30 = _e809;
local_31 = _e809;
local_32 = _e809;
local_33 = _e809;
local_34 = _e809;
local_35 = _e809;
local_36 = _e809;
local_37 = _e809;
local_38 = _e809;
local_39 = _e809;
local_40 = _e809;
local_41 = _e809;
local_42 = _e809;
local_43 = _e809;
local_44 = _e809;
local_45 = _e809;
let _e815 = ((_e811 < 256i) && (_e809.member_6 == 0f));
local_46 = _e809.member_6;
if _e815 {
let _e826 = (1f / select(_e809.member_1.x, select(1e-12f, -1e-12f, (_e809.member_1.x < 0f)), (bitcast<f32>((bitcast<u32>(_e809.member_1.x) & 2147483647u)) < 1e-12f)));
let _e835 = (1f / select(_e809.member_1.y, select(1e-12f, -1e-12f, (_e809.member_1.y < 0f)), (bitcast<f32>((bitcast<u32>(_e809.member_1.y) & 2147483647u)) < 1e-12f)));
let _e844 = (1f / select(_e809.member_1.z, select(1e-12f, -1e-12f, (_e809.member_1.z < 0f)), (bitcast<f32>((bitcast<u32>(_e809.member_1.z) & 2147483647u)) < 1e-12f)));
let _e848 = ((_e435.member - _e809.member.x) * _e826);
let _e850 = ((_e441.member - _e809.member.x) * _e826);
let _e853 = ((_e435.member_1 - _e809.member.y) * _e835);
let _e855 = ((_e441.member_1 - _e809.member.y) * _e835);
let _e858 = ((_e435.member_2 - _e809.member.z) * _e844);
let _e860 = ((_e441.member_2 - _e809.member.z) * _e844);
let _e862 = select(_e850, _e848, (_e848 > _e850));
let _e864 = select(_e855, _e853, (_e853 > _e855));
let _e866 = select(_e864, _e862, (_e862 < _e864));
let _e868 = select(_e860, _e858, (_e858 > _e860));
let _e870 = select(_e868, _e866, (_e866 < _e868));
let _e874 = global_1.member.member_4.member;
let _e875 = bitcast<i32>(_e874);
let _e879 = global_1.member.member_4.member_1;
let _e880 = bitcast<i32>(_e879);
let _e884 = global_1.member.member_4.member_2;
let _e887 = ((_e809.member.x - 0.5f) / 4f);
let _e889 = f32((_e875 - 1i));
let _e891 = select(0f, _e887, (_e887 > 0f));
let _e893 = select(_e889, _e891, (_e891 < _e889));
let _e900 = select(0i, select(select(i32(_e893), i32(-2147483648), (_e893 < -2147483600f)), 2147483647i, (_e893 > 2147483500f)), (_e893 == _e893));
let _e904 = (_e900 - select(0i, 1i, (_e893 < f32(_e900))));
let _e906 = ((_e809.member.y - 0.5f) / 4f);
let _e908 = f32((_e880 - 1i));
let _e910 = select(0f, _e906, (_e906 > 0f));
let _e912 = select(_e908, _e910, (_e910 < _e908));
let _e919 = select(0i, select(select(i32(_e912), i32(-2147483648), (_e912 < -2147483600f)), 2147483647i, (_e912 > 2147483500f)), (_e912 == _e912));
let _e923 = (_e919 - select(0i, 1i, (_e912 < f32(_e919))));
let _e925 = ((_e809.member.z - 0.5f) / 4f);
let _e927 = f32((bitcast<i32>(_e884) - 1i));
let _e929 = select(0f, _e925, (_e925 > 0f));
let _e931 = select(_e927, _e929, (_e929 < _e927));
let _e938 = select(0i, select(select(i32(_e931), i32(-2147483648), (_e931 < -2147483600f)), 2147483647i, (_e931 > 2147483500f)), (_e931 == _e931));
let _e942 = (_e938 - select(0i, 1i, (_e931 < f32(_e938))));
let _e946 = ((((_e942 * _e880) + _e923) * _e875) + _e904);
let _e948 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e950 = select(_e948, _e946, (_e946 < _e948));
let _e956 = global_4.member[bitcast<u32>(select(0i, _e950, (_e950 > 0i)))];
let _e957 = bitcast<i32>(_e956);
if (_e957 > 0i) {
let _e987 = ((((f32(((_e904 - _e957) + 1i)) * 4f) + 0.5f) - _e809.member.x) * _e826);
let _e989 = ((((f32((_e904 + _e957)) * 4f) + 0.5f) - _e809.member.x) * _e826);
let _e991 = ((((f32(((_e923 - _e957) + 1i)) * 4f) + 0.5f) - _e809.member.y) * _e835);
let _e993 = ((((f32((_e923 + _e957)) * 4f) + 0.5f) - _e809.member.y) * _e835);
let _e995 = ((((f32(((_e942 - _e957) + 1i)) * 4f) + 0.5f) - _e809.member.z) * _e844);
let _e997 = ((((f32((_e942 + _e957)) * 4f) + 0.5f) - _e809.member.z) * _e844);
let _e999 = select(_e989, _e987, (_e987 > _e989));
let _e1001 = select(_e993, _e991, (_e991 > _e993));
let _e1003 = select(_e1001, _e999, (_e999 < _e1001));
let _e1005 = select(_e997, _e995, (_e995 > _e997));
let _e1007 = select(_e1005, _e1003, (_e1003 < _e1005));
phi_1527_ = (select(0f, _e1007, (_e1007 > 0f)) + 1e-3f);
} else {
phi_1527_ = 0.5f;
}
let _e1012 = phi_1527_;
let _e1015 = (select(0f, _e870, (_e870 > 0f)) + 1e-3f);
let _e1017 = select(_e1015, _e1012, (_e1012 < _e1015));
let _e1019 = (_e809.member_14 <= _e1017);
let _e1020 = select(_e1017, _e809.member_14, _e1019);
let _e1030 = global_1.member.member_3;
let _e1032 = (bitcast<i32>(_e1030) - 1i);
phi_1565_ = _e1032;
phi_1568_ = 16i;
loop {
let _e1034 = phi_1565_;
let _e1036 = phi_1568_;
local_3 = _e1036;
local_21 = _e1036;
let _e1037 = (_e1034 >= 0i);
if _e1037 {
let _e1041 = global_1.member.member_2.member;
let _e1046 = global_1.member.member_2.member_1;
let _e1051 = global_1.member.member_2.member_2;
let _e1053 = ((_e809.member.x + (_e809.member_1.x * _e1020)) - 0.5f);
let _e1054 = ((_e809.member.y + (_e809.member_1.y * _e1020)) - 0.5f);
let _e1055 = ((_e809.member.z + (_e809.member_1.z * _e1020)) - 0.5f);
let _e1057 = f32((bitcast<i32>(_e1041) - 2i));
let _e1059 = select(0f, _e1053, (_e1053 > 0f));
let _e1061 = select(_e1057, _e1059, (_e1059 < _e1057));
let _e1068 = select(0i, select(select(i32(_e1061), i32(-2147483648), (_e1061 < -2147483600f)), 2147483647i, (_e1061 > 2147483500f)), (_e1061 == _e1061));
let _e1072 = (_e1068 - select(0i, 1i, (_e1061 < f32(_e1068))));
let _e1074 = f32((bitcast<i32>(_e1046) - 2i));
let _e1076 = select(0f, _e1054, (_e1054 > 0f));
let _e1078 = select(_e1074, _e1076, (_e1076 < _e1074));
let _e1085 = select(0i, select(select(i32(_e1078), i32(-2147483648), (_e1078 < -2147483600f)), 2147483647i, (_e1078 > 2147483500f)), (_e1078 == _e1078));
let _e1089 = (_e1085 - select(0i, 1i, (_e1078 < f32(_e1085))));
let _e1091 = f32((bitcast<i32>(_e1051) - 2i));
let _e1093 = select(0f, _e1055, (_e1055 > 0f));
let _e1095 = select(_e1091, _e1093, (_e1093 < _e1091));
let _e1102 = select(0i, select(select(i32(_e1095), i32(-2147483648), (_e1095 < -2147483600f)), 2147483647i, (_e1095 > 2147483500f)), (_e1095 == _e1095));
let _e1106 = (_e1102 - select(0i, 1i, (_e1095 < f32(_e1102))));
let _e1107 = (_e1034 * 4i);
let _e1108 = (_e1107 + 1i);
let _e1110 = (bitcast<i32>(_e92) - 1i);
let _e1112 = select(_e1110, _e1108, (_e1108 < _e1110));
let _e1118 = global_5.member[bitcast<u32>(select(0i, _e1112, (_e1112 > 0i)))];
let _e1119 = (_e1107 + 2i);
let _e1121 = select(_e1110, _e1119, (_e1119 < _e1110));
let _e1127 = global_5.member[bitcast<u32>(select(0i, _e1121, (_e1121 > 0i)))];
let _e1128 = (_e1107 + 3i);
let _e1130 = select(_e1110, _e1128, (_e1128 < _e1110));
let _e1136 = global_5.member[bitcast<u32>(select(0i, _e1130, (_e1130 > 0i)))];
let _e1139 = (_e1072 - bitcast<i32>((_e1118 & 65535u)));
let _e1144 = bitcast<i32>((_e1118 >> bitcast<u32>(16i)));
let _e1149 = (_e1089 - bitcast<i32>((_e1127 & 65535u)));
let _e1154 = bitcast<i32>((_e1127 >> bitcast<u32>(16i)));
let _e1159 = (_e1106 - bitcast<i32>((_e1136 & 65535u)));
if ((((_e1139 >= 0i) && ((_e1139 + 1i) < _e1144)) && ((_e1149 >= 0i) && ((_e1149 + 1i) < _e1154))) && ((_e1159 >= 0i) && ((_e1159 + 1i) < bitcast<i32>((_e1136 >> bitcast<u32>(16i)))))) {
let _e1169 = (_e1154 * _e1144);
let _e1171 = select(_e1110, _e1107, (_e1107 < _e1110));
let _e1177 = global_5.member[bitcast<u32>(select(0i, _e1171, (_e1171 > 0i)))];
let _e1183 = (((bitcast<i32>(_e1177) + (_e1159 * _e1169)) + (_e1149 * _e1144)) + _e1139);
let _e1185 = (_e1053 - f32(_e1072));
let _e1187 = (_e1054 - f32(_e1089));
let _e1190 = (2i * _e1183);
let _e1192 = (_e1190 >> bitcast<u32>(2i));
let _e1195 = bitcast<u32>(((_e1190 & 3i) * 8i));
let _e1197 = select(_e1110, _e1192, (_e1192 < _e1110));
let _e1203 = global_5.member[bitcast<u32>(select(0i, _e1197, (_e1197 > 0i)))];
let _e1207 = (_e1192 + 1i);
let _e1209 = select(_e1110, _e1207, (_e1207 < _e1110));
let _e1215 = global_5.member[bitcast<u32>(select(0i, _e1209, (_e1209 > 0i)))];
let _e1222 = ((_e1203 >> bitcast<u32>((_e1195 & 31u))) | ((_e1215 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1195) & 31u))));
let _e1225 = f32(bitcast<i32>((_e1222 & 65535u)));
let _e1232 = (_e1225 + ((f32(bitcast<i32>((_e1222 >> bitcast<u32>(16i)))) - _e1225) * _e1185));
let _e1234 = (2i * (_e1183 + _e1144));
let _e1236 = (_e1234 >> bitcast<u32>(2i));
let _e1239 = bitcast<u32>(((_e1234 & 3i) * 8i));
let _e1241 = select(_e1110, _e1236, (_e1236 < _e1110));
let _e1247 = global_5.member[bitcast<u32>(select(0i, _e1241, (_e1241 > 0i)))];
let _e1251 = (_e1236 + 1i);
let _e1253 = select(_e1110, _e1251, (_e1251 < _e1110));
let _e1259 = global_5.member[bitcast<u32>(select(0i, _e1253, (_e1253 > 0i)))];
let _e1266 = ((_e1247 >> bitcast<u32>((_e1239 & 31u))) | ((_e1259 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1239) & 31u))));
let _e1269 = f32(bitcast<i32>((_e1266 & 65535u)));
let _e1277 = (_e1183 + _e1169);
let _e1278 = (2i * _e1277);
let _e1280 = (_e1278 >> bitcast<u32>(2i));
let _e1283 = bitcast<u32>(((_e1278 & 3i) * 8i));
let _e1285 = select(_e1110, _e1280, (_e1280 < _e1110));
let _e1291 = global_5.member[bitcast<u32>(select(0i, _e1285, (_e1285 > 0i)))];
let _e1295 = (_e1280 + 1i);
let _e1297 = select(_e1110, _e1295, (_e1295 < _e1110));
let _e1303 = global_5.member[bitcast<u32>(select(0i, _e1297, (_e1297 > 0i)))];
let _e1310 = ((_e1291 >> bitcast<u32>((_e1283 & 31u))) | ((_e1303 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1283) & 31u))));
let _e1313 = f32(bitcast<i32>((_e1310 & 65535u)));
let _e1320 = (_e1313 + ((f32(bitcast<i32>((_e1310 >> bitcast<u32>(16i)))) - _e1313) * _e1185));
let _e1322 = (2i * (_e1277 + _e1144));
let _e1324 = (_e1322 >> bitcast<u32>(2i));
let _e1327 = bitcast<u32>(((_e1322 & 3i) * 8i));
let _e1329 = select(_e1110, _e1324, (_e1324 < _e1110));
let _e1335 = global_5.member[bitcast<u32>(select(0i, _e1329, (_e1329 > 0i)))];
let _e1339 = (_e1324 + 1i);
let _e1341 = select(_e1110, _e1339, (_e1339 < _e1110));
let _e1347 = global_5.member[bitcast<u32>(select(0i, _e1341, (_e1341 > 0i)))];
let _e1354 = ((_e1335 >> bitcast<u32>((_e1327 & 31u))) | ((_e1347 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1327) & 31u))));
let _e1357 = f32(bitcast<i32>((_e1354 & 65535u)));
let _e1367 = (_e1232 + (((_e1269 + ((f32(bitcast<i32>((_e1266 >> bitcast<u32>(16i)))) - _e1269) * _e1185)) - _e1232) * _e1187));
phi_2004_ = (_e1367 + (((_e1320 + (((_e1357 + ((f32(bitcast<i32>((_e1354 >> bitcast<u32>(16i)))) - _e1357) * _e1185)) - _e1320) * _e1187)) - _e1367) * (_e1055 - f32(_e1106))));
} else {
phi_2004_ = 0f;
}
let _e1375 = phi_2004_;
phi_1566_ = (_e1034 - 1i);
phi_1569_ = select(_e1036, _e1034, (_e1375 > 32767.5f));
} else {
phi_1566_ = i32();
phi_1569_ = i32();
}
let _e1380 = phi_1566_;
let _e1382 = phi_1569_;
continue;
continuing {
phi_1565_ = _e1380;
phi_1568_ = _e1382;
break if !(_e1037);
}
}
let _e1385 = local_3;
let _e1386 = (_e1385 == _e809.member_7);
if _e1386 {
phi_6684_ = _e809;
phi_6685_ = _e1386;
} else {
phi_2016_ = 0i;
phi_2019_ = 0f;
phi_2021_ = _e1020;
loop {
let _e1388 = phi_2016_;
let _e1390 = phi_2019_;
let _e1392 = phi_2021_;
local_5 = _e1392;
local_6 = _e1392;
local_7 = _e1392;
local_10 = _e1392;
local_12 = _e1392;
local_13 = _e1392;
local_14 = _e1392;
local_15 = _e1392;
local_16 = _e1392;
let _e1393 = (_e1388 < 12i);
if _e1393 {
let _e1395 = (0.5f * (_e1390 + _e1392));
phi_2050_ = _e1032;
phi_2053_ = 16i;
loop {
let _e1403 = phi_2050_;
let _e1405 = phi_2053_;
local_4 = _e1405;
let _e1406 = (_e1403 >= 0i);
if _e1406 {
let _e1410 = global_1.member.member_2.member;
let _e1415 = global_1.member.member_2.member_1;
let _e1420 = global_1.member.member_2.member_2;
let _e1422 = ((_e809.member.x + (_e809.member_1.x * _e1395)) - 0.5f);
let _e1423 = ((_e809.member.y + (_e809.member_1.y * _e1395)) - 0.5f);
let _e1424 = ((_e809.member.z + (_e809.member_1.z * _e1395)) - 0.5f);
let _e1426 = f32((bitcast<i32>(_e1410) - 2i));
let _e1428 = select(0f, _e1422, (_e1422 > 0f));
let _e1430 = select(_e1426, _e1428, (_e1428 < _e1426));
let _e1437 = select(0i, select(select(i32(_e1430), i32(-2147483648), (_e1430 < -2147483600f)), 2147483647i, (_e1430 > 2147483500f)), (_e1430 == _e1430));
let _e1441 = (_e1437 - select(0i, 1i, (_e1430 < f32(_e1437))));
let _e1443 = f32((bitcast<i32>(_e1415) - 2i));
let _e1445 = select(0f, _e1423, (_e1423 > 0f));
let _e1447 = select(_e1443, _e1445, (_e1445 < _e1443));
let _e1454 = select(0i, select(select(i32(_e1447), i32(-2147483648), (_e1447 < -2147483600f)), 2147483647i, (_e1447 > 2147483500f)), (_e1447 == _e1447));
let _e1458 = (_e1454 - select(0i, 1i, (_e1447 < f32(_e1454))));
let _e1460 = f32((bitcast<i32>(_e1420) - 2i));
let _e1462 = select(0f, _e1424, (_e1424 > 0f));
let _e1464 = select(_e1460, _e1462, (_e1462 < _e1460));
let _e1471 = select(0i, select(select(i32(_e1464), i32(-2147483648), (_e1464 < -2147483600f)), 2147483647i, (_e1464 > 2147483500f)), (_e1464 == _e1464));
let _e1475 = (_e1471 - select(0i, 1i, (_e1464 < f32(_e1471))));
let _e1476 = (_e1403 * 4i);
let _e1477 = (_e1476 + 1i);
let _e1479 = (bitcast<i32>(_e92) - 1i);
let _e1481 = select(_e1479, _e1477, (_e1477 < _e1479));
let _e1487 = global_5.member[bitcast<u32>(select(0i, _e1481, (_e1481 > 0i)))];
let _e1488 = (_e1476 + 2i);
let _e1490 = select(_e1479, _e1488, (_e1488 < _e1479));
let _e1496 = global_5.member[bitcast<u32>(select(0i, _e1490, (_e1490 > 0i)))];
let _e1497 = (_e1476 + 3i);
let _e1499 = select(_e1479, _e1497, (_e1497 < _e1479));
let _e1505 = global_5.member[bitcast<u32>(select(0i, _e1499, (_e1499 > 0i)))];
let _e1508 = (_e1441 - bitcast<i32>((_e1487 & 65535u)));
let _e1513 = bitcast<i32>((_e1487 >> bitcast<u32>(16i)));
let _e1518 = (_e1458 - bitcast<i32>((_e1496 & 65535u)));
let _e1523 = bitcast<i32>((_e1496 >> bitcast<u32>(16i)));
let _e1528 = (_e1475 - bitcast<i32>((_e1505 & 65535u)));
if ((((_e1508 >= 0i) && ((_e1508 + 1i) < _e1513)) && ((_e1518 >= 0i) && ((_e1518 + 1i) < _e1523))) && ((_e1528 >= 0i) && ((_e1528 + 1i) < bitcast<i32>((_e1505 >> bitcast<u32>(16i)))))) {
let _e1538 = (_e1523 * _e1513);
let _e1540 = select(_e1479, _e1476, (_e1476 < _e1479));
let _e1546 = global_5.member[bitcast<u32>(select(0i, _e1540, (_e1540 > 0i)))];
let _e1552 = (((bitcast<i32>(_e1546) + (_e1528 * _e1538)) + (_e1518 * _e1513)) + _e1508);
let _e1554 = (_e1422 - f32(_e1441));
let _e1556 = (_e1423 - f32(_e1458));
let _e1559 = (2i * _e1552);
let _e1561 = (_e1559 >> bitcast<u32>(2i));
let _e1564 = bitcast<u32>(((_e1559 & 3i) * 8i));
let _e1566 = select(_e1479, _e1561, (_e1561 < _e1479));
let _e1572 = global_5.member[bitcast<u32>(select(0i, _e1566, (_e1566 > 0i)))];
let _e1576 = (_e1561 + 1i);
let _e1578 = select(_e1479, _e1576, (_e1576 < _e1479));
let _e1584 = global_5.member[bitcast<u32>(select(0i, _e1578, (_e1578 > 0i)))];
let _e1591 = ((_e1572 >> bitcast<u32>((_e1564 & 31u))) | ((_e1584 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1564) & 31u))));
let _e1594 = f32(bitcast<i32>((_e1591 & 65535u)));
let _e1601 = (_e1594 + ((f32(bitcast<i32>((_e1591 >> bitcast<u32>(16i)))) - _e1594) * _e1554));
let _e1603 = (2i * (_e1552 + _e1513));
let _e1605 = (_e1603 >> bitcast<u32>(2i));
let _e1608 = bitcast<u32>(((_e1603 & 3i) * 8i));
let _e1610 = select(_e1479, _e1605, (_e1605 < _e1479));
let _e1616 = global_5.member[bitcast<u32>(select(0i, _e1610, (_e1610 > 0i)))];
let _e1620 = (_e1605 + 1i);
let _e1622 = select(_e1479, _e1620, (_e1620 < _e1479));
let _e1628 = global_5.member[bitcast<u32>(select(0i, _e1622, (_e1622 > 0i)))];
let _e1635 = ((_e1616 >> bitcast<u32>((_e1608 & 31u))) | ((_e1628 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1608) & 31u))));
let _e1638 = f32(bitcast<i32>((_e1635 & 65535u)));
let _e1646 = (_e1552 + _e1538);
let _e1647 = (2i * _e1646);
let _e1649 = (_e1647 >> bitcast<u32>(2i));
let _e1652 = bitcast<u32>(((_e1647 & 3i) * 8i));
let _e1654 = select(_e1479, _e1649, (_e1649 < _e1479));
let _e1660 = global_5.member[bitcast<u32>(select(0i, _e1654, (_e1654 > 0i)))];
let _e1664 = (_e1649 + 1i);
let _e1666 = select(_e1479, _e1664, (_e1664 < _e1479));
let _e1672 = global_5.member[bitcast<u32>(select(0i, _e1666, (_e1666 > 0i)))];
let _e1679 = ((_e1660 >> bitcast<u32>((_e1652 & 31u))) | ((_e1672 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1652) & 31u))));
let _e1682 = f32(bitcast<i32>((_e1679 & 65535u)));
let _e1689 = (_e1682 + ((f32(bitcast<i32>((_e1679 >> bitcast<u32>(16i)))) - _e1682) * _e1554));
let _e1691 = (2i * (_e1646 + _e1513));
let _e1693 = (_e1691 >> bitcast<u32>(2i));
let _e1696 = bitcast<u32>(((_e1691 & 3i) * 8i));
let _e1698 = select(_e1479, _e1693, (_e1693 < _e1479));
let _e1704 = global_5.member[bitcast<u32>(select(0i, _e1698, (_e1698 > 0i)))];
let _e1708 = (_e1693 + 1i);
let _e1710 = select(_e1479, _e1708, (_e1708 < _e1479));
let _e1716 = global_5.member[bitcast<u32>(select(0i, _e1710, (_e1710 > 0i)))];
let _e1723 = ((_e1704 >> bitcast<u32>((_e1696 & 31u))) | ((_e1716 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1696) & 31u))));
let _e1726 = f32(bitcast<i32>((_e1723 & 65535u)));
let _e1736 = (_e1601 + (((_e1638 + ((f32(bitcast<i32>((_e1635 >> bitcast<u32>(16i)))) - _e1638) * _e1554)) - _e1601) * _e1556));
phi_2489_ = (_e1736 + (((_e1689 + (((_e1726 + ((f32(bitcast<i32>((_e1723 >> bitcast<u32>(16i)))) - _e1726) * _e1554)) - _e1689) * _e1556)) - _e1736) * (_e1424 - f32(_e1475))));
} else {
phi_2489_ = 0f;
}
let _e1744 = phi_2489_;
phi_2051_ = (_e1403 - 1i);
phi_2054_ = select(_e1405, _e1403, (_e1744 > 32767.5f));
} else {
phi_2051_ = i32();
phi_2054_ = i32();
}
let _e1749 = phi_2051_;
let _e1751 = phi_2054_;
continue;
continuing {
phi_2050_ = _e1749;
phi_2053_ = _e1751;
break if !(_e1406);
}
}
let _e1754 = local_4;
let _e1755 = (_e1754 == _e809.member_7);
phi_2017_ = (_e1388 + 1i);
phi_2020_ = select(_e1390, _e1395, _e1755);
phi_2022_ = select(_e1395, _e1392, _e1755);
} else {
phi_2017_ = i32();
phi_2020_ = f32();
phi_2022_ = f32();
}
let _e1760 = phi_2017_;
let _e1762 = phi_2020_;
let _e1764 = phi_2022_;
continue;
continuing {
phi_2016_ = _e1760;
phi_2019_ = _e1762;
phi_2021_ = _e1764;
break if !(_e1393);
}
}
let _e1767 = local_5;
let _e1768 = (_e809.member_1.x * _e1767);
let _e1770 = local_6;
let _e1771 = (_e809.member_1.y * _e1770);
let _e1773 = local_7;
let _e1774 = (_e809.member_1.z * _e1773);
phi_2524_ = _e1032;
phi_2527_ = 16i;
loop {
let _e1781 = phi_2524_;
let _e1783 = phi_2527_;
local_8 = _e1783;
local_9 = _e1783;
local_11 = _e1783;
local_17 = _e1783;
local_18 = _e1783;
local_19 = _e1783;
local_20 = _e1783;
let _e1784 = (_e1781 >= 0i);
if _e1784 {
let _e1788 = global_1.member.member_2.member;
let _e1793 = global_1.member.member_2.member_1;
let _e1798 = global_1.member.member_2.member_2;
let _e1800 = ((_e809.member.x + _e1768) - 0.5f);
let _e1801 = ((_e809.member.y + _e1771) - 0.5f);
let _e1802 = ((_e809.member.z + _e1774) - 0.5f);
let _e1804 = f32((bitcast<i32>(_e1788) - 2i));
let _e1806 = select(0f, _e1800, (_e1800 > 0f));
let _e1808 = select(_e1804, _e1806, (_e1806 < _e1804));
let _e1815 = select(0i, select(select(i32(_e1808), i32(-2147483648), (_e1808 < -2147483600f)), 2147483647i, (_e1808 > 2147483500f)), (_e1808 == _e1808));
let _e1819 = (_e1815 - select(0i, 1i, (_e1808 < f32(_e1815))));
let _e1821 = f32((bitcast<i32>(_e1793) - 2i));
let _e1823 = select(0f, _e1801, (_e1801 > 0f));
let _e1825 = select(_e1821, _e1823, (_e1823 < _e1821));
let _e1832 = select(0i, select(select(i32(_e1825), i32(-2147483648), (_e1825 < -2147483600f)), 2147483647i, (_e1825 > 2147483500f)), (_e1825 == _e1825));
let _e1836 = (_e1832 - select(0i, 1i, (_e1825 < f32(_e1832))));
let _e1838 = f32((bitcast<i32>(_e1798) - 2i));
let _e1840 = select(0f, _e1802, (_e1802 > 0f));
let _e1842 = select(_e1838, _e1840, (_e1840 < _e1838));
let _e1849 = select(0i, select(select(i32(_e1842), i32(-2147483648), (_e1842 < -2147483600f)), 2147483647i, (_e1842 > 2147483500f)), (_e1842 == _e1842));
let _e1853 = (_e1849 - select(0i, 1i, (_e1842 < f32(_e1849))));
let _e1854 = (_e1781 * 4i);
let _e1855 = (_e1854 + 1i);
let _e1857 = (bitcast<i32>(_e92) - 1i);
let _e1859 = select(_e1857, _e1855, (_e1855 < _e1857));
let _e1865 = global_5.member[bitcast<u32>(select(0i, _e1859, (_e1859 > 0i)))];
let _e1866 = (_e1854 + 2i);
let _e1868 = select(_e1857, _e1866, (_e1866 < _e1857));
let _e1874 = global_5.member[bitcast<u32>(select(0i, _e1868, (_e1868 > 0i)))];
let _e1875 = (_e1854 + 3i);
let _e1877 = select(_e1857, _e1875, (_e1875 < _e1857));
let _e1883 = global_5.member[bitcast<u32>(select(0i, _e1877, (_e1877 > 0i)))];
let _e1886 = (_e1819 - bitcast<i32>((_e1865 & 65535u)));
let _e1891 = bitcast<i32>((_e1865 >> bitcast<u32>(16i)));
let _e1896 = (_e1836 - bitcast<i32>((_e1874 & 65535u)));
let _e1901 = bitcast<i32>((_e1874 >> bitcast<u32>(16i)));
let _e1906 = (_e1853 - bitcast<i32>((_e1883 & 65535u)));
if ((((_e1886 >= 0i) && ((_e1886 + 1i) < _e1891)) && ((_e1896 >= 0i) && ((_e1896 + 1i) < _e1901))) && ((_e1906 >= 0i) && ((_e1906 + 1i) < bitcast<i32>((_e1883 >> bitcast<u32>(16i)))))) {
let _e1916 = (_e1901 * _e1891);
let _e1918 = select(_e1857, _e1854, (_e1854 < _e1857));
let _e1924 = global_5.member[bitcast<u32>(select(0i, _e1918, (_e1918 > 0i)))];
let _e1930 = (((bitcast<i32>(_e1924) + (_e1906 * _e1916)) + (_e1896 * _e1891)) + _e1886);
let _e1932 = (_e1800 - f32(_e1819));
let _e1934 = (_e1801 - f32(_e1836));
let _e1937 = (2i * _e1930);
let _e1939 = (_e1937 >> bitcast<u32>(2i));
let _e1942 = bitcast<u32>(((_e1937 & 3i) * 8i));
let _e1944 = select(_e1857, _e1939, (_e1939 < _e1857));
let _e1950 = global_5.member[bitcast<u32>(select(0i, _e1944, (_e1944 > 0i)))];
let _e1954 = (_e1939 + 1i);
let _e1956 = select(_e1857, _e1954, (_e1954 < _e1857));
let _e1962 = global_5.member[bitcast<u32>(select(0i, _e1956, (_e1956 > 0i)))];
let _e1969 = ((_e1950 >> bitcast<u32>((_e1942 & 31u))) | ((_e1962 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1942) & 31u))));
let _e1972 = f32(bitcast<i32>((_e1969 & 65535u)));
let _e1979 = (_e1972 + ((f32(bitcast<i32>((_e1969 >> bitcast<u32>(16i)))) - _e1972) * _e1932));
let _e1981 = (2i * (_e1930 + _e1891));
let _e1983 = (_e1981 >> bitcast<u32>(2i));
let _e1986 = bitcast<u32>(((_e1981 & 3i) * 8i));
let _e1988 = select(_e1857, _e1983, (_e1983 < _e1857));
let _e1994 = global_5.member[bitcast<u32>(select(0i, _e1988, (_e1988 > 0i)))];
let _e1998 = (_e1983 + 1i);
let _e2000 = select(_e1857, _e1998, (_e1998 < _e1857));
let _e2006 = global_5.member[bitcast<u32>(select(0i, _e2000, (_e2000 > 0i)))];
let _e2013 = ((_e1994 >> bitcast<u32>((_e1986 & 31u))) | ((_e2006 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e1986) & 31u))));
let _e2016 = f32(bitcast<i32>((_e2013 & 65535u)));
let _e2024 = (_e1930 + _e1916);
let _e2025 = (2i * _e2024);
let _e2027 = (_e2025 >> bitcast<u32>(2i));
let _e2030 = bitcast<u32>(((_e2025 & 3i) * 8i));
let _e2032 = select(_e1857, _e2027, (_e2027 < _e1857));
let _e2038 = global_5.member[bitcast<u32>(select(0i, _e2032, (_e2032 > 0i)))];
let _e2042 = (_e2027 + 1i);
let _e2044 = select(_e1857, _e2042, (_e2042 < _e1857));
let _e2050 = global_5.member[bitcast<u32>(select(0i, _e2044, (_e2044 > 0i)))];
let _e2057 = ((_e2038 >> bitcast<u32>((_e2030 & 31u))) | ((_e2050 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2030) & 31u))));
let _e2060 = f32(bitcast<i32>((_e2057 & 65535u)));
let _e2067 = (_e2060 + ((f32(bitcast<i32>((_e2057 >> bitcast<u32>(16i)))) - _e2060) * _e1932));
let _e2069 = (2i * (_e2024 + _e1891));
let _e2071 = (_e2069 >> bitcast<u32>(2i));
let _e2074 = bitcast<u32>(((_e2069 & 3i) * 8i));
let _e2076 = select(_e1857, _e2071, (_e2071 < _e1857));
let _e2082 = global_5.member[bitcast<u32>(select(0i, _e2076, (_e2076 > 0i)))];
let _e2086 = (_e2071 + 1i);
let _e2088 = select(_e1857, _e2086, (_e2086 < _e1857));
let _e2094 = global_5.member[bitcast<u32>(select(0i, _e2088, (_e2088 > 0i)))];
let _e2101 = ((_e2082 >> bitcast<u32>((_e2074 & 31u))) | ((_e2094 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2074) & 31u))));
let _e2104 = f32(bitcast<i32>((_e2101 & 65535u)));
let _e2114 = (_e1979 + (((_e2016 + ((f32(bitcast<i32>((_e2013 >> bitcast<u32>(16i)))) - _e2016) * _e1932)) - _e1979) * _e1934));
phi_2963_ = (_e2114 + (((_e2067 + (((_e2104 + ((f32(bitcast<i32>((_e2101 >> bitcast<u32>(16i)))) - _e2104) * _e1932)) - _e2067) * _e1934)) - _e2114) * (_e1802 - f32(_e1853))));
} else {
phi_2963_ = 0f;
}
let _e2122 = phi_2963_;
phi_2525_ = (_e1781 - 1i);
phi_2528_ = select(_e1783, _e1781, (_e2122 > 32767.5f));
} else {
phi_2525_ = i32();
phi_2528_ = i32();
}
let _e2127 = phi_2525_;
let _e2129 = phi_2528_;
continue;
continuing {
phi_2524_ = _e2127;
phi_2527_ = _e2129;
break if !(_e1784);
}
}
let _e2132 = local_8;
let _e2135 = local_9;
local = select(_e809.member_7, _e2135, (_e2132 < _e809.member_7));
local_1 = (_e809.member + vec3<f32>(_e1768, _e1771, _e1774));
let _e2140 = local;
let _e2141 = local_1[0u];
let _e2143 = local_1[1u];
let _e2145 = local_1[2u];
let _e2149 = global_1.member.member_2.member;
let _e2153 = global_1.member.member_2.member_1;
let _e2157 = global_1.member.member_2.member_2;
let _e2159 = ((_e2141 + -1f) - 0.5f);
let _e2160 = ((_e2143 + 0f) - 0.5f);
let _e2161 = ((_e2145 + 0f) - 0.5f);
let _e2163 = f32((bitcast<i32>(_e2149) - 2i));
let _e2165 = select(0f, _e2159, (_e2159 > 0f));
let _e2167 = select(_e2163, _e2165, (_e2165 < _e2163));
let _e2174 = select(0i, select(select(i32(_e2167), i32(-2147483648), (_e2167 < -2147483600f)), 2147483647i, (_e2167 > 2147483500f)), (_e2167 == _e2167));
let _e2178 = (_e2174 - select(0i, 1i, (_e2167 < f32(_e2174))));
let _e2180 = f32((bitcast<i32>(_e2153) - 2i));
let _e2182 = select(0f, _e2160, (_e2160 > 0f));
let _e2184 = select(_e2180, _e2182, (_e2182 < _e2180));
let _e2191 = select(0i, select(select(i32(_e2184), i32(-2147483648), (_e2184 < -2147483600f)), 2147483647i, (_e2184 > 2147483500f)), (_e2184 == _e2184));
let _e2195 = (_e2191 - select(0i, 1i, (_e2184 < f32(_e2191))));
let _e2197 = f32((bitcast<i32>(_e2157) - 2i));
let _e2199 = select(0f, _e2161, (_e2161 > 0f));
let _e2201 = select(_e2197, _e2199, (_e2199 < _e2197));
let _e2208 = select(0i, select(select(i32(_e2201), i32(-2147483648), (_e2201 < -2147483600f)), 2147483647i, (_e2201 > 2147483500f)), (_e2201 == _e2201));
let _e2212 = (_e2208 - select(0i, 1i, (_e2201 < f32(_e2208))));
let _e2213 = (_e2140 * 4i);
let _e2214 = (_e2213 + 1i);
let _e2216 = (bitcast<i32>(_e92) - 1i);
let _e2218 = select(_e2216, _e2214, (_e2214 < _e2216));
let _e2223 = global_5.member[bitcast<u32>(select(0i, _e2218, (_e2218 > 0i)))];
let _e2224 = (_e2213 + 2i);
let _e2226 = select(_e2216, _e2224, (_e2224 < _e2216));
let _e2231 = global_5.member[bitcast<u32>(select(0i, _e2226, (_e2226 > 0i)))];
let _e2232 = (_e2213 + 3i);
let _e2234 = select(_e2216, _e2232, (_e2232 < _e2216));
let _e2239 = global_5.member[bitcast<u32>(select(0i, _e2234, (_e2234 > 0i)))];
let _e2242 = (_e2178 - bitcast<i32>((_e2223 & 65535u)));
let _e2247 = bitcast<i32>((_e2223 >> bitcast<u32>(16i)));
let _e2252 = (_e2195 - bitcast<i32>((_e2231 & 65535u)));
let _e2257 = bitcast<i32>((_e2231 >> bitcast<u32>(16i)));
let _e2262 = (_e2212 - bitcast<i32>((_e2239 & 65535u)));
if ((((_e2242 >= 0i) && ((_e2242 + 1i) < _e2247)) && ((_e2252 >= 0i) && ((_e2252 + 1i) < _e2257))) && ((_e2262 >= 0i) && ((_e2262 + 1i) < bitcast<i32>((_e2239 >> bitcast<u32>(16i)))))) {
let _e2272 = (_e2257 * _e2247);
let _e2274 = select(_e2216, _e2213, (_e2213 < _e2216));
let _e2279 = global_5.member[bitcast<u32>(select(0i, _e2274, (_e2274 > 0i)))];
let _e2285 = (((bitcast<i32>(_e2279) + (_e2262 * _e2272)) + (_e2252 * _e2247)) + _e2242);
let _e2287 = (_e2159 - f32(_e2178));
let _e2289 = (_e2160 - f32(_e2195));
let _e2292 = (2i * _e2285);
let _e2294 = (_e2292 >> bitcast<u32>(2i));
let _e2297 = bitcast<u32>(((_e2292 & 3i) * 8i));
let _e2299 = select(_e2216, _e2294, (_e2294 < _e2216));
let _e2304 = global_5.member[bitcast<u32>(select(0i, _e2299, (_e2299 > 0i)))];
let _e2308 = (_e2294 + 1i);
let _e2310 = select(_e2216, _e2308, (_e2308 < _e2216));
let _e2315 = global_5.member[bitcast<u32>(select(0i, _e2310, (_e2310 > 0i)))];
let _e2322 = ((_e2304 >> bitcast<u32>((_e2297 & 31u))) | ((_e2315 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2297) & 31u))));
let _e2325 = f32(bitcast<i32>((_e2322 & 65535u)));
let _e2332 = (_e2325 + ((f32(bitcast<i32>((_e2322 >> bitcast<u32>(16i)))) - _e2325) * _e2287));
let _e2334 = (2i * (_e2285 + _e2247));
let _e2336 = (_e2334 >> bitcast<u32>(2i));
let _e2339 = bitcast<u32>(((_e2334 & 3i) * 8i));
let _e2341 = select(_e2216, _e2336, (_e2336 < _e2216));
let _e2346 = global_5.member[bitcast<u32>(select(0i, _e2341, (_e2341 > 0i)))];
let _e2350 = (_e2336 + 1i);
let _e2352 = select(_e2216, _e2350, (_e2350 < _e2216));
let _e2357 = global_5.member[bitcast<u32>(select(0i, _e2352, (_e2352 > 0i)))];
let _e2364 = ((_e2346 >> bitcast<u32>((_e2339 & 31u))) | ((_e2357 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2339) & 31u))));
let _e2367 = f32(bitcast<i32>((_e2364 & 65535u)));
let _e2375 = (_e2285 + _e2272);
let _e2376 = (2i * _e2375);
let _e2378 = (_e2376 >> bitcast<u32>(2i));
let _e2381 = bitcast<u32>(((_e2376 & 3i) * 8i));
let _e2383 = select(_e2216, _e2378, (_e2378 < _e2216));
let _e2388 = global_5.member[bitcast<u32>(select(0i, _e2383, (_e2383 > 0i)))];
let _e2392 = (_e2378 + 1i);
let _e2394 = select(_e2216, _e2392, (_e2392 < _e2216));
let _e2399 = global_5.member[bitcast<u32>(select(0i, _e2394, (_e2394 > 0i)))];
let _e2406 = ((_e2388 >> bitcast<u32>((_e2381 & 31u))) | ((_e2399 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2381) & 31u))));
let _e2409 = f32(bitcast<i32>((_e2406 & 65535u)));
let _e2416 = (_e2409 + ((f32(bitcast<i32>((_e2406 >> bitcast<u32>(16i)))) - _e2409) * _e2287));
let _e2418 = (2i * (_e2375 + _e2247));
let _e2420 = (_e2418 >> bitcast<u32>(2i));
let _e2423 = bitcast<u32>(((_e2418 & 3i) * 8i));
let _e2425 = select(_e2216, _e2420, (_e2420 < _e2216));
let _e2430 = global_5.member[bitcast<u32>(select(0i, _e2425, (_e2425 > 0i)))];
let _e2434 = (_e2420 + 1i);
let _e2436 = select(_e2216, _e2434, (_e2434 < _e2216));
let _e2441 = global_5.member[bitcast<u32>(select(0i, _e2436, (_e2436 > 0i)))];
let _e2448 = ((_e2430 >> bitcast<u32>((_e2423 & 31u))) | ((_e2441 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2423) & 31u))));
let _e2451 = f32(bitcast<i32>((_e2448 & 65535u)));
let _e2461 = (_e2332 + (((_e2367 + ((f32(bitcast<i32>((_e2364 >> bitcast<u32>(16i)))) - _e2367) * _e2287)) - _e2332) * _e2289));
phi_3423_ = (_e2461 + (((_e2416 + (((_e2451 + ((f32(bitcast<i32>((_e2448 >> bitcast<u32>(16i)))) - _e2451) * _e2287)) - _e2416) * _e2289)) - _e2461) * (_e2161 - f32(_e2212))));
} else {
phi_3423_ = 0f;
}
let _e2469 = phi_3423_;
let _e2470 = local;
let _e2471 = local_1[0u];
let _e2473 = local_1[1u];
let _e2475 = local_1[2u];
let _e2477 = ((_e2471 + 1f) - 0.5f);
let _e2478 = ((_e2473 + 0f) - 0.5f);
let _e2479 = ((_e2475 + 0f) - 0.5f);
let _e2481 = select(0f, _e2477, (_e2477 > 0f));
let _e2483 = select(_e2163, _e2481, (_e2481 < _e2163));
let _e2490 = select(0i, select(select(i32(_e2483), i32(-2147483648), (_e2483 < -2147483600f)), 2147483647i, (_e2483 > 2147483500f)), (_e2483 == _e2483));
let _e2494 = (_e2490 - select(0i, 1i, (_e2483 < f32(_e2490))));
let _e2496 = select(0f, _e2478, (_e2478 > 0f));
let _e2498 = select(_e2180, _e2496, (_e2496 < _e2180));
let _e2505 = select(0i, select(select(i32(_e2498), i32(-2147483648), (_e2498 < -2147483600f)), 2147483647i, (_e2498 > 2147483500f)), (_e2498 == _e2498));
let _e2509 = (_e2505 - select(0i, 1i, (_e2498 < f32(_e2505))));
let _e2511 = select(0f, _e2479, (_e2479 > 0f));
let _e2513 = select(_e2197, _e2511, (_e2511 < _e2197));
let _e2520 = select(0i, select(select(i32(_e2513), i32(-2147483648), (_e2513 < -2147483600f)), 2147483647i, (_e2513 > 2147483500f)), (_e2513 == _e2513));
let _e2524 = (_e2520 - select(0i, 1i, (_e2513 < f32(_e2520))));
let _e2525 = (_e2470 * 4i);
let _e2526 = (_e2525 + 1i);
let _e2528 = select(_e2216, _e2526, (_e2526 < _e2216));
let _e2533 = global_5.member[bitcast<u32>(select(0i, _e2528, (_e2528 > 0i)))];
let _e2534 = (_e2525 + 2i);
let _e2536 = select(_e2216, _e2534, (_e2534 < _e2216));
let _e2541 = global_5.member[bitcast<u32>(select(0i, _e2536, (_e2536 > 0i)))];
let _e2542 = (_e2525 + 3i);
let _e2544 = select(_e2216, _e2542, (_e2542 < _e2216));
let _e2549 = global_5.member[bitcast<u32>(select(0i, _e2544, (_e2544 > 0i)))];
let _e2552 = (_e2494 - bitcast<i32>((_e2533 & 65535u)));
let _e2557 = bitcast<i32>((_e2533 >> bitcast<u32>(16i)));
let _e2562 = (_e2509 - bitcast<i32>((_e2541 & 65535u)));
let _e2567 = bitcast<i32>((_e2541 >> bitcast<u32>(16i)));
let _e2572 = (_e2524 - bitcast<i32>((_e2549 & 65535u)));
if ((((_e2552 >= 0i) && ((_e2552 + 1i) < _e2557)) && ((_e2562 >= 0i) && ((_e2562 + 1i) < _e2567))) && ((_e2572 >= 0i) && ((_e2572 + 1i) < bitcast<i32>((_e2549 >> bitcast<u32>(16i)))))) {
let _e2582 = (_e2567 * _e2557);
let _e2584 = select(_e2216, _e2525, (_e2525 < _e2216));
let _e2589 = global_5.member[bitcast<u32>(select(0i, _e2584, (_e2584 > 0i)))];
let _e2595 = (((bitcast<i32>(_e2589) + (_e2572 * _e2582)) + (_e2562 * _e2557)) + _e2552);
let _e2597 = (_e2477 - f32(_e2494));
let _e2599 = (_e2478 - f32(_e2509));
let _e2602 = (2i * _e2595);
let _e2604 = (_e2602 >> bitcast<u32>(2i));
let _e2607 = bitcast<u32>(((_e2602 & 3i) * 8i));
let _e2609 = select(_e2216, _e2604, (_e2604 < _e2216));
let _e2614 = global_5.member[bitcast<u32>(select(0i, _e2609, (_e2609 > 0i)))];
let _e2618 = (_e2604 + 1i);
let _e2620 = select(_e2216, _e2618, (_e2618 < _e2216));
let _e2625 = global_5.member[bitcast<u32>(select(0i, _e2620, (_e2620 > 0i)))];
let _e2632 = ((_e2614 >> bitcast<u32>((_e2607 & 31u))) | ((_e2625 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2607) & 31u))));
let _e2635 = f32(bitcast<i32>((_e2632 & 65535u)));
let _e2642 = (_e2635 + ((f32(bitcast<i32>((_e2632 >> bitcast<u32>(16i)))) - _e2635) * _e2597));
let _e2644 = (2i * (_e2595 + _e2557));
let _e2646 = (_e2644 >> bitcast<u32>(2i));
let _e2649 = bitcast<u32>(((_e2644 & 3i) * 8i));
let _e2651 = select(_e2216, _e2646, (_e2646 < _e2216));
let _e2656 = global_5.member[bitcast<u32>(select(0i, _e2651, (_e2651 > 0i)))];
let _e2660 = (_e2646 + 1i);
let _e2662 = select(_e2216, _e2660, (_e2660 < _e2216));
let _e2667 = global_5.member[bitcast<u32>(select(0i, _e2662, (_e2662 > 0i)))];
let _e2674 = ((_e2656 >> bitcast<u32>((_e2649 & 31u))) | ((_e2667 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2649) & 31u))));
let _e2677 = f32(bitcast<i32>((_e2674 & 65535u)));
let _e2685 = (_e2595 + _e2582);
let _e2686 = (2i * _e2685);
let _e2688 = (_e2686 >> bitcast<u32>(2i));
let _e2691 = bitcast<u32>(((_e2686 & 3i) * 8i));
let _e2693 = select(_e2216, _e2688, (_e2688 < _e2216));
let _e2698 = global_5.member[bitcast<u32>(select(0i, _e2693, (_e2693 > 0i)))];
let _e2702 = (_e2688 + 1i);
let _e2704 = select(_e2216, _e2702, (_e2702 < _e2216));
let _e2709 = global_5.member[bitcast<u32>(select(0i, _e2704, (_e2704 > 0i)))];
let _e2716 = ((_e2698 >> bitcast<u32>((_e2691 & 31u))) | ((_e2709 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2691) & 31u))));
let _e2719 = f32(bitcast<i32>((_e2716 & 65535u)));
let _e2726 = (_e2719 + ((f32(bitcast<i32>((_e2716 >> bitcast<u32>(16i)))) - _e2719) * _e2597));
let _e2728 = (2i * (_e2685 + _e2557));
let _e2730 = (_e2728 >> bitcast<u32>(2i));
let _e2733 = bitcast<u32>(((_e2728 & 3i) * 8i));
let _e2735 = select(_e2216, _e2730, (_e2730 < _e2216));
let _e2740 = global_5.member[bitcast<u32>(select(0i, _e2735, (_e2735 > 0i)))];
let _e2744 = (_e2730 + 1i);
let _e2746 = select(_e2216, _e2744, (_e2744 < _e2216));
let _e2751 = global_5.member[bitcast<u32>(select(0i, _e2746, (_e2746 > 0i)))];
let _e2758 = ((_e2740 >> bitcast<u32>((_e2733 & 31u))) | ((_e2751 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2733) & 31u))));
let _e2761 = f32(bitcast<i32>((_e2758 & 65535u)));
let _e2771 = (_e2642 + (((_e2677 + ((f32(bitcast<i32>((_e2674 >> bitcast<u32>(16i)))) - _e2677) * _e2597)) - _e2642) * _e2599));
phi_3862_ = (_e2771 + (((_e2726 + (((_e2761 + ((f32(bitcast<i32>((_e2758 >> bitcast<u32>(16i)))) - _e2761) * _e2597)) - _e2726) * _e2599)) - _e2771) * (_e2479 - f32(_e2524))));
} else {
phi_3862_ = 0f;
}
let _e2779 = phi_3862_;
let _e2780 = (_e2469 - _e2779);
let _e2781 = local;
let _e2782 = local_1[0u];
let _e2784 = local_1[1u];
let _e2786 = local_1[2u];
let _e2788 = ((_e2782 + 0f) - 0.5f);
let _e2789 = ((_e2784 + -1f) - 0.5f);
let _e2790 = ((_e2786 + 0f) - 0.5f);
let _e2792 = select(0f, _e2788, (_e2788 > 0f));
let _e2794 = select(_e2163, _e2792, (_e2792 < _e2163));
let _e2801 = select(0i, select(select(i32(_e2794), i32(-2147483648), (_e2794 < -2147483600f)), 2147483647i, (_e2794 > 2147483500f)), (_e2794 == _e2794));
let _e2805 = (_e2801 - select(0i, 1i, (_e2794 < f32(_e2801))));
let _e2807 = select(0f, _e2789, (_e2789 > 0f));
let _e2809 = select(_e2180, _e2807, (_e2807 < _e2180));
let _e2816 = select(0i, select(select(i32(_e2809), i32(-2147483648), (_e2809 < -2147483600f)), 2147483647i, (_e2809 > 2147483500f)), (_e2809 == _e2809));
let _e2820 = (_e2816 - select(0i, 1i, (_e2809 < f32(_e2816))));
let _e2822 = select(0f, _e2790, (_e2790 > 0f));
let _e2824 = select(_e2197, _e2822, (_e2822 < _e2197));
let _e2831 = select(0i, select(select(i32(_e2824), i32(-2147483648), (_e2824 < -2147483600f)), 2147483647i, (_e2824 > 2147483500f)), (_e2824 == _e2824));
let _e2835 = (_e2831 - select(0i, 1i, (_e2824 < f32(_e2831))));
let _e2836 = (_e2781 * 4i);
let _e2837 = (_e2836 + 1i);
let _e2839 = select(_e2216, _e2837, (_e2837 < _e2216));
let _e2844 = global_5.member[bitcast<u32>(select(0i, _e2839, (_e2839 > 0i)))];
let _e2845 = (_e2836 + 2i);
let _e2847 = select(_e2216, _e2845, (_e2845 < _e2216));
let _e2852 = global_5.member[bitcast<u32>(select(0i, _e2847, (_e2847 > 0i)))];
let _e2853 = (_e2836 + 3i);
let _e2855 = select(_e2216, _e2853, (_e2853 < _e2216));
let _e2860 = global_5.member[bitcast<u32>(select(0i, _e2855, (_e2855 > 0i)))];
let _e2863 = (_e2805 - bitcast<i32>((_e2844 & 65535u)));
let _e2868 = bitcast<i32>((_e2844 >> bitcast<u32>(16i)));
let _e2873 = (_e2820 - bitcast<i32>((_e2852 & 65535u)));
let _e2878 = bitcast<i32>((_e2852 >> bitcast<u32>(16i)));
let _e2883 = (_e2835 - bitcast<i32>((_e2860 & 65535u)));
if ((((_e2863 >= 0i) && ((_e2863 + 1i) < _e2868)) && ((_e2873 >= 0i) && ((_e2873 + 1i) < _e2878))) && ((_e2883 >= 0i) && ((_e2883 + 1i) < bitcast<i32>((_e2860 >> bitcast<u32>(16i)))))) {
let _e2893 = (_e2878 * _e2868);
let _e2895 = select(_e2216, _e2836, (_e2836 < _e2216));
let _e2900 = global_5.member[bitcast<u32>(select(0i, _e2895, (_e2895 > 0i)))];
let _e2906 = (((bitcast<i32>(_e2900) + (_e2883 * _e2893)) + (_e2873 * _e2868)) + _e2863);
let _e2908 = (_e2788 - f32(_e2805));
let _e2910 = (_e2789 - f32(_e2820));
let _e2913 = (2i * _e2906);
let _e2915 = (_e2913 >> bitcast<u32>(2i));
let _e2918 = bitcast<u32>(((_e2913 & 3i) * 8i));
let _e2920 = select(_e2216, _e2915, (_e2915 < _e2216));
let _e2925 = global_5.member[bitcast<u32>(select(0i, _e2920, (_e2920 > 0i)))];
let _e2929 = (_e2915 + 1i);
let _e2931 = select(_e2216, _e2929, (_e2929 < _e2216));
let _e2936 = global_5.member[bitcast<u32>(select(0i, _e2931, (_e2931 > 0i)))];
let _e2943 = ((_e2925 >> bitcast<u32>((_e2918 & 31u))) | ((_e2936 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2918) & 31u))));
let _e2946 = f32(bitcast<i32>((_e2943 & 65535u)));
let _e2953 = (_e2946 + ((f32(bitcast<i32>((_e2943 >> bitcast<u32>(16i)))) - _e2946) * _e2908));
let _e2955 = (2i * (_e2906 + _e2868));
let _e2957 = (_e2955 >> bitcast<u32>(2i));
let _e2960 = bitcast<u32>(((_e2955 & 3i) * 8i));
let _e2962 = select(_e2216, _e2957, (_e2957 < _e2216));
let _e2967 = global_5.member[bitcast<u32>(select(0i, _e2962, (_e2962 > 0i)))];
let _e2971 = (_e2957 + 1i);
let _e2973 = select(_e2216, _e2971, (_e2971 < _e2216));
let _e2978 = global_5.member[bitcast<u32>(select(0i, _e2973, (_e2973 > 0i)))];
let _e2985 = ((_e2967 >> bitcast<u32>((_e2960 & 31u))) | ((_e2978 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e2960) & 31u))));
let _e2988 = f32(bitcast<i32>((_e2985 & 65535u)));
let _e2996 = (_e2906 + _e2893);
let _e2997 = (2i * _e2996);
let _e2999 = (_e2997 >> bitcast<u32>(2i));
let _e3002 = bitcast<u32>(((_e2997 & 3i) * 8i));
let _e3004 = select(_e2216, _e2999, (_e2999 < _e2216));
let _e3009 = global_5.member[bitcast<u32>(select(0i, _e3004, (_e3004 > 0i)))];
let _e3013 = (_e2999 + 1i);
let _e3015 = select(_e2216, _e3013, (_e3013 < _e2216));
let _e3020 = global_5.member[bitcast<u32>(select(0i, _e3015, (_e3015 > 0i)))];
let _e3027 = ((_e3009 >> bitcast<u32>((_e3002 & 31u))) | ((_e3020 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3002) & 31u))));
let _e3030 = f32(bitcast<i32>((_e3027 & 65535u)));
let _e3037 = (_e3030 + ((f32(bitcast<i32>((_e3027 >> bitcast<u32>(16i)))) - _e3030) * _e2908));
let _e3039 = (2i * (_e2996 + _e2868));
let _e3041 = (_e3039 >> bitcast<u32>(2i));
let _e3044 = bitcast<u32>(((_e3039 & 3i) * 8i));
let _e3046 = select(_e2216, _e3041, (_e3041 < _e2216));
let _e3051 = global_5.member[bitcast<u32>(select(0i, _e3046, (_e3046 > 0i)))];
let _e3055 = (_e3041 + 1i);
let _e3057 = select(_e2216, _e3055, (_e3055 < _e2216));
let _e3062 = global_5.member[bitcast<u32>(select(0i, _e3057, (_e3057 > 0i)))];
let _e3069 = ((_e3051 >> bitcast<u32>((_e3044 & 31u))) | ((_e3062 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3044) & 31u))));
let _e3072 = f32(bitcast<i32>((_e3069 & 65535u)));
let _e3082 = (_e2953 + (((_e2988 + ((f32(bitcast<i32>((_e2985 >> bitcast<u32>(16i)))) - _e2988) * _e2908)) - _e2953) * _e2910));
phi_4302_ = (_e3082 + (((_e3037 + (((_e3072 + ((f32(bitcast<i32>((_e3069 >> bitcast<u32>(16i)))) - _e3072) * _e2908)) - _e3037) * _e2910)) - _e3082) * (_e2790 - f32(_e2835))));
} else {
phi_4302_ = 0f;
}
let _e3090 = phi_4302_;
let _e3091 = local;
let _e3092 = local_1[0u];
let _e3094 = local_1[1u];
let _e3096 = local_1[2u];
let _e3098 = ((_e3092 + 0f) - 0.5f);
let _e3099 = ((_e3094 + 1f) - 0.5f);
let _e3100 = ((_e3096 + 0f) - 0.5f);
let _e3102 = select(0f, _e3098, (_e3098 > 0f));
let _e3104 = select(_e2163, _e3102, (_e3102 < _e2163));
let _e3111 = select(0i, select(select(i32(_e3104), i32(-2147483648), (_e3104 < -2147483600f)), 2147483647i, (_e3104 > 2147483500f)), (_e3104 == _e3104));
let _e3115 = (_e3111 - select(0i, 1i, (_e3104 < f32(_e3111))));
let _e3117 = select(0f, _e3099, (_e3099 > 0f));
let _e3119 = select(_e2180, _e3117, (_e3117 < _e2180));
let _e3126 = select(0i, select(select(i32(_e3119), i32(-2147483648), (_e3119 < -2147483600f)), 2147483647i, (_e3119 > 2147483500f)), (_e3119 == _e3119));
let _e3130 = (_e3126 - select(0i, 1i, (_e3119 < f32(_e3126))));
let _e3132 = select(0f, _e3100, (_e3100 > 0f));
let _e3134 = select(_e2197, _e3132, (_e3132 < _e2197));
let _e3141 = select(0i, select(select(i32(_e3134), i32(-2147483648), (_e3134 < -2147483600f)), 2147483647i, (_e3134 > 2147483500f)), (_e3134 == _e3134));
let _e3145 = (_e3141 - select(0i, 1i, (_e3134 < f32(_e3141))));
let _e3146 = (_e3091 * 4i);
let _e3147 = (_e3146 + 1i);
let _e3149 = select(_e2216, _e3147, (_e3147 < _e2216));
let _e3154 = global_5.member[bitcast<u32>(select(0i, _e3149, (_e3149 > 0i)))];
let _e3155 = (_e3146 + 2i);
let _e3157 = select(_e2216, _e3155, (_e3155 < _e2216));
let _e3162 = global_5.member[bitcast<u32>(select(0i, _e3157, (_e3157 > 0i)))];
let _e3163 = (_e3146 + 3i);
let _e3165 = select(_e2216, _e3163, (_e3163 < _e2216));
let _e3170 = global_5.member[bitcast<u32>(select(0i, _e3165, (_e3165 > 0i)))];
let _e3173 = (_e3115 - bitcast<i32>((_e3154 & 65535u)));
let _e3178 = bitcast<i32>((_e3154 >> bitcast<u32>(16i)));
let _e3183 = (_e3130 - bitcast<i32>((_e3162 & 65535u)));
let _e3188 = bitcast<i32>((_e3162 >> bitcast<u32>(16i)));
let _e3193 = (_e3145 - bitcast<i32>((_e3170 & 65535u)));
if ((((_e3173 >= 0i) && ((_e3173 + 1i) < _e3178)) && ((_e3183 >= 0i) && ((_e3183 + 1i) < _e3188))) && ((_e3193 >= 0i) && ((_e3193 + 1i) < bitcast<i32>((_e3170 >> bitcast<u32>(16i)))))) {
let _e3203 = (_e3188 * _e3178);
let _e3205 = select(_e2216, _e3146, (_e3146 < _e2216));
let _e3210 = global_5.member[bitcast<u32>(select(0i, _e3205, (_e3205 > 0i)))];
let _e3216 = (((bitcast<i32>(_e3210) + (_e3193 * _e3203)) + (_e3183 * _e3178)) + _e3173);
let _e3218 = (_e3098 - f32(_e3115));
let _e3220 = (_e3099 - f32(_e3130));
let _e3223 = (2i * _e3216);
let _e3225 = (_e3223 >> bitcast<u32>(2i));
let _e3228 = bitcast<u32>(((_e3223 & 3i) * 8i));
let _e3230 = select(_e2216, _e3225, (_e3225 < _e2216));
let _e3235 = global_5.member[bitcast<u32>(select(0i, _e3230, (_e3230 > 0i)))];
let _e3239 = (_e3225 + 1i);
let _e3241 = select(_e2216, _e3239, (_e3239 < _e2216));
let _e3246 = global_5.member[bitcast<u32>(select(0i, _e3241, (_e3241 > 0i)))];
let _e3253 = ((_e3235 >> bitcast<u32>((_e3228 & 31u))) | ((_e3246 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3228) & 31u))));
let _e3256 = f32(bitcast<i32>((_e3253 & 65535u)));
let _e3263 = (_e3256 + ((f32(bitcast<i32>((_e3253 >> bitcast<u32>(16i)))) - _e3256) * _e3218));
let _e3265 = (2i * (_e3216 + _e3178));
let _e3267 = (_e3265 >> bitcast<u32>(2i));
let _e3270 = bitcast<u32>(((_e3265 & 3i) * 8i));
let _e3272 = select(_e2216, _e3267, (_e3267 < _e2216));
let _e3277 = global_5.member[bitcast<u32>(select(0i, _e3272, (_e3272 > 0i)))];
let _e3281 = (_e3267 + 1i);
let _e3283 = select(_e2216, _e3281, (_e3281 < _e2216));
let _e3288 = global_5.member[bitcast<u32>(select(0i, _e3283, (_e3283 > 0i)))];
let _e3295 = ((_e3277 >> bitcast<u32>((_e3270 & 31u))) | ((_e3288 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3270) & 31u))));
let _e3298 = f32(bitcast<i32>((_e3295 & 65535u)));
let _e3306 = (_e3216 + _e3203);
let _e3307 = (2i * _e3306);
let _e3309 = (_e3307 >> bitcast<u32>(2i));
let _e3312 = bitcast<u32>(((_e3307 & 3i) * 8i));
let _e3314 = select(_e2216, _e3309, (_e3309 < _e2216));
let _e3319 = global_5.member[bitcast<u32>(select(0i, _e3314, (_e3314 > 0i)))];
let _e3323 = (_e3309 + 1i);
let _e3325 = select(_e2216, _e3323, (_e3323 < _e2216));
let _e3330 = global_5.member[bitcast<u32>(select(0i, _e3325, (_e3325 > 0i)))];
let _e3337 = ((_e3319 >> bitcast<u32>((_e3312 & 31u))) | ((_e3330 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3312) & 31u))));
let _e3340 = f32(bitcast<i32>((_e3337 & 65535u)));
let _e3347 = (_e3340 + ((f32(bitcast<i32>((_e3337 >> bitcast<u32>(16i)))) - _e3340) * _e3218));
let _e3349 = (2i * (_e3306 + _e3178));
let _e3351 = (_e3349 >> bitcast<u32>(2i));
let _e3354 = bitcast<u32>(((_e3349 & 3i) * 8i));
let _e3356 = select(_e2216, _e3351, (_e3351 < _e2216));
let _e3361 = global_5.member[bitcast<u32>(select(0i, _e3356, (_e3356 > 0i)))];
let _e3365 = (_e3351 + 1i);
let _e3367 = select(_e2216, _e3365, (_e3365 < _e2216));
let _e3372 = global_5.member[bitcast<u32>(select(0i, _e3367, (_e3367 > 0i)))];
let _e3379 = ((_e3361 >> bitcast<u32>((_e3354 & 31u))) | ((_e3372 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3354) & 31u))));
let _e3382 = f32(bitcast<i32>((_e3379 & 65535u)));
let _e3392 = (_e3263 + (((_e3298 + ((f32(bitcast<i32>((_e3295 >> bitcast<u32>(16i)))) - _e3298) * _e3218)) - _e3263) * _e3220));
phi_4741_ = (_e3392 + (((_e3347 + (((_e3382 + ((f32(bitcast<i32>((_e3379 >> bitcast<u32>(16i)))) - _e3382) * _e3218)) - _e3347) * _e3220)) - _e3392) * (_e3100 - f32(_e3145))));
} else {
phi_4741_ = 0f;
}
let _e3400 = phi_4741_;
let _e3401 = (_e3090 - _e3400);
let _e3402 = local;
let _e3403 = local_1[0u];
let _e3405 = local_1[1u];
let _e3407 = local_1[2u];
let _e3409 = ((_e3403 + 0f) - 0.5f);
let _e3410 = ((_e3405 + 0f) - 0.5f);
let _e3411 = ((_e3407 + -1f) - 0.5f);
let _e3413 = select(0f, _e3409, (_e3409 > 0f));
let _e3415 = select(_e2163, _e3413, (_e3413 < _e2163));
let _e3422 = select(0i, select(select(i32(_e3415), i32(-2147483648), (_e3415 < -2147483600f)), 2147483647i, (_e3415 > 2147483500f)), (_e3415 == _e3415));
let _e3426 = (_e3422 - select(0i, 1i, (_e3415 < f32(_e3422))));
let _e3428 = select(0f, _e3410, (_e3410 > 0f));
let _e3430 = select(_e2180, _e3428, (_e3428 < _e2180));
let _e3437 = select(0i, select(select(i32(_e3430), i32(-2147483648), (_e3430 < -2147483600f)), 2147483647i, (_e3430 > 2147483500f)), (_e3430 == _e3430));
let _e3441 = (_e3437 - select(0i, 1i, (_e3430 < f32(_e3437))));
let _e3443 = select(0f, _e3411, (_e3411 > 0f));
let _e3445 = select(_e2197, _e3443, (_e3443 < _e2197));
let _e3452 = select(0i, select(select(i32(_e3445), i32(-2147483648), (_e3445 < -2147483600f)), 2147483647i, (_e3445 > 2147483500f)), (_e3445 == _e3445));
let _e3456 = (_e3452 - select(0i, 1i, (_e3445 < f32(_e3452))));
let _e3457 = (_e3402 * 4i);
let _e3458 = (_e3457 + 1i);
let _e3460 = select(_e2216, _e3458, (_e3458 < _e2216));
let _e3465 = global_5.member[bitcast<u32>(select(0i, _e3460, (_e3460 > 0i)))];
let _e3466 = (_e3457 + 2i);
let _e3468 = select(_e2216, _e3466, (_e3466 < _e2216));
let _e3473 = global_5.member[bitcast<u32>(select(0i, _e3468, (_e3468 > 0i)))];
let _e3474 = (_e3457 + 3i);
let _e3476 = select(_e2216, _e3474, (_e3474 < _e2216));
let _e3481 = global_5.member[bitcast<u32>(select(0i, _e3476, (_e3476 > 0i)))];
let _e3484 = (_e3426 - bitcast<i32>((_e3465 & 65535u)));
let _e3489 = bitcast<i32>((_e3465 >> bitcast<u32>(16i)));
let _e3494 = (_e3441 - bitcast<i32>((_e3473 & 65535u)));
let _e3499 = bitcast<i32>((_e3473 >> bitcast<u32>(16i)));
let _e3504 = (_e3456 - bitcast<i32>((_e3481 & 65535u)));
if ((((_e3484 >= 0i) && ((_e3484 + 1i) < _e3489)) && ((_e3494 >= 0i) && ((_e3494 + 1i) < _e3499))) && ((_e3504 >= 0i) && ((_e3504 + 1i) < bitcast<i32>((_e3481 >> bitcast<u32>(16i)))))) {
let _e3514 = (_e3499 * _e3489);
let _e3516 = select(_e2216, _e3457, (_e3457 < _e2216));
let _e3521 = global_5.member[bitcast<u32>(select(0i, _e3516, (_e3516 > 0i)))];
let _e3527 = (((bitcast<i32>(_e3521) + (_e3504 * _e3514)) + (_e3494 * _e3489)) + _e3484);
let _e3529 = (_e3409 - f32(_e3426));
let _e3531 = (_e3410 - f32(_e3441));
let _e3534 = (2i * _e3527);
let _e3536 = (_e3534 >> bitcast<u32>(2i));
let _e3539 = bitcast<u32>(((_e3534 & 3i) * 8i));
let _e3541 = select(_e2216, _e3536, (_e3536 < _e2216));
let _e3546 = global_5.member[bitcast<u32>(select(0i, _e3541, (_e3541 > 0i)))];
let _e3550 = (_e3536 + 1i);
let _e3552 = select(_e2216, _e3550, (_e3550 < _e2216));
let _e3557 = global_5.member[bitcast<u32>(select(0i, _e3552, (_e3552 > 0i)))];
let _e3564 = ((_e3546 >> bitcast<u32>((_e3539 & 31u))) | ((_e3557 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3539) & 31u))));
let _e3567 = f32(bitcast<i32>((_e3564 & 65535u)));
let _e3574 = (_e3567 + ((f32(bitcast<i32>((_e3564 >> bitcast<u32>(16i)))) - _e3567) * _e3529));
let _e3576 = (2i * (_e3527 + _e3489));
let _e3578 = (_e3576 >> bitcast<u32>(2i));
let _e3581 = bitcast<u32>(((_e3576 & 3i) * 8i));
let _e3583 = select(_e2216, _e3578, (_e3578 < _e2216));
let _e3588 = global_5.member[bitcast<u32>(select(0i, _e3583, (_e3583 > 0i)))];
let _e3592 = (_e3578 + 1i);
let _e3594 = select(_e2216, _e3592, (_e3592 < _e2216));
let _e3599 = global_5.member[bitcast<u32>(select(0i, _e3594, (_e3594 > 0i)))];
let _e3606 = ((_e3588 >> bitcast<u32>((_e3581 & 31u))) | ((_e3599 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3581) & 31u))));
let _e3609 = f32(bitcast<i32>((_e3606 & 65535u)));
let _e3617 = (_e3527 + _e3514);
let _e3618 = (2i * _e3617);
let _e3620 = (_e3618 >> bitcast<u32>(2i));
let _e3623 = bitcast<u32>(((_e3618 & 3i) * 8i));
let _e3625 = select(_e2216, _e3620, (_e3620 < _e2216));
let _e3630 = global_5.member[bitcast<u32>(select(0i, _e3625, (_e3625 > 0i)))];
let _e3634 = (_e3620 + 1i);
let _e3636 = select(_e2216, _e3634, (_e3634 < _e2216));
let _e3641 = global_5.member[bitcast<u32>(select(0i, _e3636, (_e3636 > 0i)))];
let _e3648 = ((_e3630 >> bitcast<u32>((_e3623 & 31u))) | ((_e3641 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3623) & 31u))));
let _e3651 = f32(bitcast<i32>((_e3648 & 65535u)));
let _e3658 = (_e3651 + ((f32(bitcast<i32>((_e3648 >> bitcast<u32>(16i)))) - _e3651) * _e3529));
let _e3660 = (2i * (_e3617 + _e3489));
let _e3662 = (_e3660 >> bitcast<u32>(2i));
let _e3665 = bitcast<u32>(((_e3660 & 3i) * 8i));
let _e3667 = select(_e2216, _e3662, (_e3662 < _e2216));
let _e3672 = global_5.member[bitcast<u32>(select(0i, _e3667, (_e3667 > 0i)))];
let _e3676 = (_e3662 + 1i);
let _e3678 = select(_e2216, _e3676, (_e3676 < _e2216));
let _e3683 = global_5.member[bitcast<u32>(select(0i, _e3678, (_e3678 > 0i)))];
let _e3690 = ((_e3672 >> bitcast<u32>((_e3665 & 31u))) | ((_e3683 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3665) & 31u))));
let _e3693 = f32(bitcast<i32>((_e3690 & 65535u)));
let _e3703 = (_e3574 + (((_e3609 + ((f32(bitcast<i32>((_e3606 >> bitcast<u32>(16i)))) - _e3609) * _e3529)) - _e3574) * _e3531));
phi_5181_ = (_e3703 + (((_e3658 + (((_e3693 + ((f32(bitcast<i32>((_e3690 >> bitcast<u32>(16i)))) - _e3693) * _e3529)) - _e3658) * _e3531)) - _e3703) * (_e3411 - f32(_e3456))));
} else {
phi_5181_ = 0f;
}
let _e3711 = phi_5181_;
let _e3712 = local;
let _e3713 = local_1[0u];
let _e3715 = local_1[1u];
let _e3717 = local_1[2u];
let _e3719 = ((_e3713 + 0f) - 0.5f);
let _e3720 = ((_e3715 + 0f) - 0.5f);
let _e3721 = ((_e3717 + 1f) - 0.5f);
let _e3723 = select(0f, _e3719, (_e3719 > 0f));
let _e3725 = select(_e2163, _e3723, (_e3723 < _e2163));
let _e3732 = select(0i, select(select(i32(_e3725), i32(-2147483648), (_e3725 < -2147483600f)), 2147483647i, (_e3725 > 2147483500f)), (_e3725 == _e3725));
let _e3736 = (_e3732 - select(0i, 1i, (_e3725 < f32(_e3732))));
let _e3738 = select(0f, _e3720, (_e3720 > 0f));
let _e3740 = select(_e2180, _e3738, (_e3738 < _e2180));
let _e3747 = select(0i, select(select(i32(_e3740), i32(-2147483648), (_e3740 < -2147483600f)), 2147483647i, (_e3740 > 2147483500f)), (_e3740 == _e3740));
let _e3751 = (_e3747 - select(0i, 1i, (_e3740 < f32(_e3747))));
let _e3753 = select(0f, _e3721, (_e3721 > 0f));
let _e3755 = select(_e2197, _e3753, (_e3753 < _e2197));
let _e3762 = select(0i, select(select(i32(_e3755), i32(-2147483648), (_e3755 < -2147483600f)), 2147483647i, (_e3755 > 2147483500f)), (_e3755 == _e3755));
let _e3766 = (_e3762 - select(0i, 1i, (_e3755 < f32(_e3762))));
let _e3767 = (_e3712 * 4i);
let _e3768 = (_e3767 + 1i);
let _e3770 = select(_e2216, _e3768, (_e3768 < _e2216));
let _e3775 = global_5.member[bitcast<u32>(select(0i, _e3770, (_e3770 > 0i)))];
let _e3776 = (_e3767 + 2i);
let _e3778 = select(_e2216, _e3776, (_e3776 < _e2216));
let _e3783 = global_5.member[bitcast<u32>(select(0i, _e3778, (_e3778 > 0i)))];
let _e3784 = (_e3767 + 3i);
let _e3786 = select(_e2216, _e3784, (_e3784 < _e2216));
let _e3791 = global_5.member[bitcast<u32>(select(0i, _e3786, (_e3786 > 0i)))];
let _e3794 = (_e3736 - bitcast<i32>((_e3775 & 65535u)));
let _e3799 = bitcast<i32>((_e3775 >> bitcast<u32>(16i)));
let _e3804 = (_e3751 - bitcast<i32>((_e3783 & 65535u)));
let _e3809 = bitcast<i32>((_e3783 >> bitcast<u32>(16i)));
let _e3814 = (_e3766 - bitcast<i32>((_e3791 & 65535u)));
if ((((_e3794 >= 0i) && ((_e3794 + 1i) < _e3799)) && ((_e3804 >= 0i) && ((_e3804 + 1i) < _e3809))) && ((_e3814 >= 0i) && ((_e3814 + 1i) < bitcast<i32>((_e3791 >> bitcast<u32>(16i)))))) {
let _e3824 = (_e3809 * _e3799);
let _e3826 = select(_e2216, _e3767, (_e3767 < _e2216));
let _e3831 = global_5.member[bitcast<u32>(select(0i, _e3826, (_e3826 > 0i)))];
let _e3837 = (((bitcast<i32>(_e3831) + (_e3814 * _e3824)) + (_e3804 * _e3799)) + _e3794);
let _e3839 = (_e3719 - f32(_e3736));
let _e3841 = (_e3720 - f32(_e3751));
let _e3844 = (2i * _e3837);
let _e3846 = (_e3844 >> bitcast<u32>(2i));
let _e3849 = bitcast<u32>(((_e3844 & 3i) * 8i));
let _e3851 = select(_e2216, _e3846, (_e3846 < _e2216));
let _e3856 = global_5.member[bitcast<u32>(select(0i, _e3851, (_e3851 > 0i)))];
let _e3860 = (_e3846 + 1i);
let _e3862 = select(_e2216, _e3860, (_e3860 < _e2216));
let _e3867 = global_5.member[bitcast<u32>(select(0i, _e3862, (_e3862 > 0i)))];
let _e3874 = ((_e3856 >> bitcast<u32>((_e3849 & 31u))) | ((_e3867 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3849) & 31u))));
let _e3877 = f32(bitcast<i32>((_e3874 & 65535u)));
let _e3884 = (_e3877 + ((f32(bitcast<i32>((_e3874 >> bitcast<u32>(16i)))) - _e3877) * _e3839));
let _e3886 = (2i * (_e3837 + _e3799));
let _e3888 = (_e3886 >> bitcast<u32>(2i));
let _e3891 = bitcast<u32>(((_e3886 & 3i) * 8i));
let _e3893 = select(_e2216, _e3888, (_e3888 < _e2216));
let _e3898 = global_5.member[bitcast<u32>(select(0i, _e3893, (_e3893 > 0i)))];
let _e3902 = (_e3888 + 1i);
let _e3904 = select(_e2216, _e3902, (_e3902 < _e2216));
let _e3909 = global_5.member[bitcast<u32>(select(0i, _e3904, (_e3904 > 0i)))];
let _e3916 = ((_e3898 >> bitcast<u32>((_e3891 & 31u))) | ((_e3909 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3891) & 31u))));
let _e3919 = f32(bitcast<i32>((_e3916 & 65535u)));
let _e3927 = (_e3837 + _e3824);
let _e3928 = (2i * _e3927);
let _e3930 = (_e3928 >> bitcast<u32>(2i));
let _e3933 = bitcast<u32>(((_e3928 & 3i) * 8i));
let _e3935 = select(_e2216, _e3930, (_e3930 < _e2216));
let _e3940 = global_5.member[bitcast<u32>(select(0i, _e3935, (_e3935 > 0i)))];
let _e3944 = (_e3930 + 1i);
let _e3946 = select(_e2216, _e3944, (_e3944 < _e2216));
let _e3951 = global_5.member[bitcast<u32>(select(0i, _e3946, (_e3946 > 0i)))];
let _e3958 = ((_e3940 >> bitcast<u32>((_e3933 & 31u))) | ((_e3951 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3933) & 31u))));
let _e3961 = f32(bitcast<i32>((_e3958 & 65535u)));
let _e3968 = (_e3961 + ((f32(bitcast<i32>((_e3958 >> bitcast<u32>(16i)))) - _e3961) * _e3839));
let _e3970 = (2i * (_e3927 + _e3799));
let _e3972 = (_e3970 >> bitcast<u32>(2i));
let _e3975 = bitcast<u32>(((_e3970 & 3i) * 8i));
let _e3977 = select(_e2216, _e3972, (_e3972 < _e2216));
let _e3982 = global_5.member[bitcast<u32>(select(0i, _e3977, (_e3977 > 0i)))];
let _e3986 = (_e3972 + 1i);
let _e3988 = select(_e2216, _e3986, (_e3986 < _e2216));
let _e3993 = global_5.member[bitcast<u32>(select(0i, _e3988, (_e3988 > 0i)))];
let _e4000 = ((_e3982 >> bitcast<u32>((_e3975 & 31u))) | ((_e3993 << bitcast<u32>(1i)) << bitcast<u32>(((31u - _e3975) & 31u))));
let _e4003 = f32(bitcast<i32>((_e4000 & 65535u)));
let _e4013 = (_e3884 + (((_e3919 + ((f32(bitcast<i32>((_e3916 >> bitcast<u32>(16i)))) - _e3919) * _e3839)) - _e3884) * _e3841));
phi_5620_ = (_e4013 + (((_e3968 + (((_e4003 + ((f32(bitcast<i32>((_e4000 >> bitcast<u32>(16i)))) - _e4003) * _e3839)) - _e3968) * _e3841)) - _e4013) * (_e3721 - f32(_e3766))));
} else {
phi_5620_ = 0f;
}
let _e4021 = phi_5620_;
let _e4022 = (_e3711 - _e4021);
let _e4027 = (((_e2780 * _e2780) + (_e3401 * _e3401)) + (_e4022 * _e4022));
let _e4030 = sqrt(select(0f, _e4027, (_e4027 > 0f)));
let _e4033 = (1f / select(1e-6f, _e4030, (_e4030 > 1e-6f)));
let _e4034 = (_e2780 * _e4033);
let _e4035 = (_e3401 * _e4033);
let _e4036 = (_e4022 * _e4033);
let _e4037 = vec3<f32>(_e4034, _e4035, _e4036);
let _e4040 = local_10;
let _e4044 = global_1.member.member_13;
let _e4057 = global_1.member.member_12;
let _e4061 = local_11;
let _e4063 = ((((_e809.member_5 + _e4040) < _e4044) && ((((_e4034 * _e809.member_4.x) + (_e4035 * _e809.member_4.y)) + (_e4036 * _e809.member_4.z)) > _e4057)) || (_e4061 == _e809.member_7));
if _e4063 {
phi_6683_ = _e809;
} else {
let _e4088 = type_20(vec3<f32>((_e809.member.x + _e1768), (_e809.member.y + _e1771), (_e809.member.z + _e1774)), _e809.member_1, _e809.member_2, _e809.member_3, _e809.member_4, _e809.member_5, _e809.member_6, _e809.member_7, _e809.member_8, _e809.member_9, _e809.member_10, _e809.member_11, _e809.member_12, _e809.member_13, _e809.member_14);
let _e4092 = local_12;
let _e4110 = type_20(_e4088.member, _e4088.member_1, _e4088.member_2, _e4088.member_3, _e4088.member_4, _e4088.member_5, _e4088.member_6, _e4088.member_7, _e4088.member_8, _e4088.member_9, (_e809.member_10 + select(0f, _e4092, (_e809.member_8 == 0f))), _e4088.member_11, _e4088.member_12, _e4088.member_13, _e4088.member_14);
if (_e809.member_7 != 16i) {
let _e4114 = local_13;
let _e4130 = type_20(_e4110.member, _e4110.member_1, _e4110.member_2, _e4110.member_3, _e4110.member_4, _e4110.member_5, _e4110.member_6, _e4110.member_7, _e4110.member_8, (_e809.member_9 + _e4114), _e4110.member_10, _e4110.member_11, _e4110.member_12, _e4110.member_13, _e4110.member_14);
let _e4131 = (_e809.member_7 * 4i);
let _e4132 = (_e4131 + 1i);
let _e4134 = (bitcast<i32>(_e94) - 1i);
let _e4136 = select(_e4134, _e4132, (_e4132 < _e4134));
let _e4142 = global_2.member[bitcast<u32>(select(0i, _e4136, (_e4136 > 0i)))];
let _e4144 = local_14;
let _e4146 = -((_e4142 * _e4144));
let _e4148 = select(-87f, _e4146, (_e4146 > -87f));
let _e4150 = select(88f, _e4148, (_e4148 < 88f));
let _e4152 = ((_e4150 * 1.442695f) + 0.5f);
let _e4154 = select(-127f, _e4152, (_e4152 > -127f));
let _e4156 = select(128f, _e4154, (_e4154 < 128f));
let _e4163 = select(0i, select(select(i32(_e4156), i32(-2147483648), (_e4156 < -2147483600f)), 2147483647i, (_e4156 > 2147483500f)), (_e4156 == _e4156));
let _e4167 = (_e4163 - select(0i, 1i, (_e4156 < f32(_e4163))));
let _e4168 = f32(_e4167);
let _e4172 = ((_e4150 - (_e4168 * 0.6933594f)) - (_e4168 * -2.1219444e-4f));
let _e4196 = (_e4131 + 2i);
let _e4198 = select(_e4134, _e4196, (_e4196 < _e4134));
let _e4204 = global_2.member[bitcast<u32>(select(0i, _e4198, (_e4198 > 0i)))];
let _e4206 = local_15;
let _e4208 = -((_e4204 * _e4206));
let _e4210 = select(-87f, _e4208, (_e4208 > -87f));
let _e4212 = select(88f, _e4210, (_e4210 < 88f));
let _e4214 = ((_e4212 * 1.442695f) + 0.5f);
let _e4216 = select(-127f, _e4214, (_e4214 > -127f));
let _e4218 = select(128f, _e4216, (_e4216 < 128f));
let _e4225 = select(0i, select(select(i32(_e4218), i32(-2147483648), (_e4218 < -2147483600f)), 2147483647i, (_e4218 > 2147483500f)), (_e4218 == _e4218));
let _e4229 = (_e4225 - select(0i, 1i, (_e4218 < f32(_e4225))));
let _e4230 = f32(_e4229);
let _e4234 = ((_e4212 - (_e4230 * 0.6933594f)) - (_e4230 * -2.1219444e-4f));
let _e4258 = (_e4131 + 3i);
let _e4260 = select(_e4134, _e4258, (_e4258 < _e4134));
let _e4266 = global_2.member[bitcast<u32>(select(0i, _e4260, (_e4260 > 0i)))];
let _e4268 = local_16;
let _e4270 = -((_e4266 * _e4268));
let _e4272 = select(-87f, _e4270, (_e4270 > -87f));
let _e4274 = select(88f, _e4272, (_e4272 < 88f));
let _e4276 = ((_e4274 * 1.442695f) + 0.5f);
let _e4278 = select(-127f, _e4276, (_e4276 > -127f));
let _e4280 = select(128f, _e4278, (_e4278 < 128f));
let _e4287 = select(0i, select(select(i32(_e4280), i32(-2147483648), (_e4280 < -2147483600f)), 2147483647i, (_e4280 > 2147483500f)), (_e4280 == _e4280));
let _e4291 = (_e4287 - select(0i, 1i, (_e4280 < f32(_e4287))));
let _e4292 = f32(_e4291);
let _e4296 = ((_e4274 - (_e4292 * 0.6933594f)) - (_e4292 * -2.1219444e-4f));
phi_5950_ = type_20(_e4130.member, _e4130.member_1, vec3<f32>((_e809.member_2.x * ((1f + (_e4172 * (1f + (_e4172 * (0.5f + (_e4172 * (0.16666667f + (_e4172 * (0.041666668f + (_e4172 * (0.008333334f + (_e4172 * (0.001388889f + (_e4172 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4167 + 127i)) << bitcast<u32>(23i))))), (_e809.member_2.y * ((1f + (_e4234 * (1f + (_e4234 * (0.5f + (_e4234 * (0.16666667f + (_e4234 * (0.041666668f + (_e4234 * (0.008333334f + (_e4234 * (0.001388889f + (_e4234 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4229 + 127i)) << bitcast<u32>(23i))))), (_e809.member_2.z * ((1f + (_e4296 * (1f + (_e4296 * (0.5f + (_e4296 * (0.16666667f + (_e4296 * (0.041666668f + (_e4296 * (0.008333334f + (_e4296 * (0.001388889f + (_e4296 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4291 + 127i)) << bitcast<u32>(23i)))))), _e4130.member_3, _e4130.member_4, _e4130.member_5, _e4130.member_6, _e4130.member_7, _e4130.member_8, _e4130.member_9, _e4130.member_10, _e4130.member_11, _e4130.member_12, _e4130.member_13, _e4130.member_14);
} else {
phi_5950_ = _e4110;
}
let _e4337 = phi_5950_;
let _e4339 = (_e809.member_7 * 4i);
let _e4341 = (bitcast<i32>(_e94) - 1i);
let _e4343 = select(_e4341, _e4339, (_e4339 < _e4341));
let _e4349 = global_2.member[bitcast<u32>(select(0i, _e4343, (_e4343 > 0i)))];
let _e4351 = select(_e4349, 1f, (_e809.member_7 == 16i));
let _e4353 = local_17;
let _e4354 = (_e4353 * 4i);
let _e4356 = select(_e4341, _e4354, (_e4354 < _e4341));
let _e4362 = global_2.member[bitcast<u32>(select(0i, _e4356, (_e4356 > 0i)))];
let _e4364 = local_18;
let _e4366 = select(_e4362, 1f, (_e4364 == 16i));
let _e4376 = select(1f, -1f, ((((_e4337.member_1.x * _e4034) + (_e4337.member_1.y * _e4035)) + (_e4337.member_1.z * _e4036)) > 0f));
let _e4377 = (_e4034 * _e4376);
let _e4378 = (_e4035 * _e4376);
let _e4379 = (_e4036 * _e4376);
let _e4385 = -((((_e4337.member_1.x * _e4377) + (_e4337.member_1.y * _e4378)) + (_e4337.member_1.z * _e4379)));
let _e4387 = select(0f, _e4385, (_e4385 > 0f));
let _e4388 = (_e4351 / _e4366);
let _e4390 = (_e4387 * _e4387);
let _e4393 = (1f - ((_e4388 * _e4388) * (1f - _e4390)));
let _e4394 = (_e4393 <= 0f);
let _e4402 = ((_e4388 * _e4387) - sqrt(select(0f, _e4393, (_e4393 > 0f))));
let _e4409 = (2f * _e4387);
let _e4416 = select(((_e4337.member_1.x * _e4388) + (_e4377 * _e4402)), (_e4337.member_1.x + (_e4377 * _e4409)), _e4394);
let _e4417 = select(((_e4337.member_1.y * _e4388) + (_e4378 * _e4402)), (_e4337.member_1.y + (_e4378 * _e4409)), _e4394);
let _e4418 = select(((_e4337.member_1.z * _e4388) + (_e4379 * _e4402)), (_e4337.member_1.z + (_e4379 * _e4409)), _e4394);
let _e4423 = (((_e4416 * _e4416) + (_e4417 * _e4417)) + (_e4418 * _e4418));
let _e4426 = sqrt(select(0f, _e4423, (_e4423 > 0f)));
let _e4429 = (1f / select(1e-20f, _e4426, (_e4426 > 1e-20f)));
let _e4434 = (_e4366 / _e4351);
let _e4437 = (((_e4434 * _e4434) - 1f) + _e4390);
let _e4440 = sqrt(select(0f, _e4437, (_e4437 > 0f)));
let _e4441 = (_e4440 - _e4387);
let _e4442 = (_e4440 + _e4387);
let _e4445 = (_e4441 / select(1e-6f, _e4442, (_e4442 > 1e-6f)));
let _e4449 = ((_e4387 * _e4441) + 1f);
let _e4452 = (((_e4387 * _e4442) - 1f) / select(1e-6f, _e4449, (_e4449 > 1e-6f)));
let _e4466 = global_1.member.member_1;
let _e4469 = select(0f, select(select((((0.5f * _e4445) * _e4445) * (1f + (_e4452 * _e4452))), 1f, (_e4437 <= 0f)), 0f, (_e4351 == _e4366)), ((_e4466 & 1u) != 0u));
if (_e4337.member_8 == 0f) {
let _e4484 = type_20(_e4337.member, _e4337.member_1, _e4337.member_2, _e4037, _e4337.member_4, _e4337.member_5, _e4337.member_6, _e4337.member_7, _e4337.member_8, _e4337.member_9, _e4337.member_10, _e4337.member_11, _e4337.member_12, _e4337.member_13, _e4337.member_14);
phi_6161_ = type_20(_e4484.member, _e4484.member_1, _e4484.member_2, _e4484.member_3, _e4484.member_4, _e4484.member_5, _e4484.member_6, _e4484.member_7, _e4484.member_8, _e4484.member_9, _e4484.member_10, _e4469, _e4484.member_12, _e4484.member_13, _e4484.member_14);
} else {
phi_6161_ = _e4337;
}
let _e4501 = phi_6161_;
let _e4503 = (_e4501.member_8 + 1f);
let _e4518 = type_20(_e4501.member, _e4501.member_1, _e4501.member_2, _e4501.member_3, _e4501.member_4, _e4501.member_5, _e4501.member_6, _e4501.member_7, _e4503, _e4501.member_9, _e4501.member_10, _e4501.member_11, _e4501.member_12, _e4501.member_13, _e4501.member_14);
let _e4521 = ((_e101.member_2 == 0u) && (_e4503 >= 2f));
if (_e4394 && _e4521) {
let _e4546 = (((_e4501.member_1.x * _e4034) + (_e4501.member_1.y * _e4035)) + (_e4501.member_1.z * _e4036));
let _e4550 = (_e4501.member_1.x - (_e4034 * _e4546));
let _e4551 = (_e4501.member_1.y - (_e4035 * _e4546));
let _e4552 = (_e4501.member_1.z - (_e4036 * _e4546));
let _e4557 = (((_e4550 * _e4550) + (_e4551 * _e4551)) + (_e4552 * _e4552));
let _e4560 = sqrt(select(0f, _e4557, (_e4557 > 0f)));
let _e4563 = (1f / select(1e-20f, _e4560, (_e4560 > 1e-20f)));
phi_6214_ = type_20(_e4518.member, vec3<f32>((_e4550 * _e4563), (_e4551 * _e4563), (_e4552 * _e4563)), _e4518.member_2, _e4518.member_3, _e4518.member_4, _e4518.member_5, _e4518.member_6, _e4518.member_7, _e4518.member_8, _e4518.member_9, _e4518.member_10, _e4518.member_11, _e4518.member_12, _e4518.member_13, _e4518.member_14);
} else {
phi_6214_ = type_20(_e4518.member, vec3<f32>((_e4416 * _e4429), (_e4417 * _e4429), (_e4418 * _e4429)), _e4518.member_2, _e4518.member_3, _e4518.member_4, _e4518.member_5, _e4518.member_6, _e4518.member_7, _e4518.member_8, _e4518.member_9, _e4518.member_10, _e4518.member_11, _e4518.member_12, _e4518.member_13, _e4518.member_14);
}
let _e4584 = phi_6214_;
if _e4394 {
phi_6228_ = _e4584;
} else {
let _e4585 = (1f - _e4469);
phi_6228_ = type_20(_e4584.member, _e4584.member_1, vec3<f32>((_e4584.member_2.x * _e4585), (_e4584.member_2.y * _e4585), (_e4584.member_2.z * _e4585)), _e4584.member_3, _e4584.member_4, _e4584.member_5, _e4584.member_6, _e4584.member_7, _e4584.member_8, _e4584.member_9, _e4584.member_10, _e4584.member_11, _e4584.member_12, _e4584.member_13, _e4584.member_14);
}
let _e4612 = phi_6228_;
let _e4619 = global_1.member.member_17.member.member;
let _e4633 = ((((_e4619.member.member * _e4612.member.x) + (_e4619.member.member_1 * _e4612.member.y)) + (_e4619.member.member_2 * _e4612.member.z)) + _e4619.member_1);
let _e4642 = -((((_e4619.member.member * _e4612.member_1.x) + (_e4619.member.member_1 * _e4612.member_1.y)) + (_e4619.member.member_2 * _e4612.member_1.z)));
let _e4644 = (_e4642 > 1e-9f);
let _e4648 = ((_e4633 / select(1e-9f, _e4642, _e4644)) - 0.015625f);
let _e4651 = select(1e30f, select(0f, _e4648, (_e4648 > 0f)), ((_e4633 > 0f) && _e4644));
let _e4656 = global_1.member.member_17.member_1.member;
let _e4667 = ((((_e4656.member.member * _e4612.member.x) + (_e4656.member.member_1 * _e4612.member.y)) + (_e4656.member.member_2 * _e4612.member.z)) + _e4656.member_1);
let _e4673 = -((((_e4656.member.member * _e4612.member_1.x) + (_e4656.member.member_1 * _e4612.member_1.y)) + (_e4656.member.member_2 * _e4612.member_1.z)));
let _e4675 = (_e4673 > 1e-9f);
let _e4679 = ((_e4667 / select(1e-9f, _e4673, _e4675)) - 0.015625f);
let _e4682 = select(1e30f, select(0f, _e4679, (_e4679 > 0f)), ((_e4667 > 0f) && _e4675));
let _e4686 = (_e4682 < _e4651);
let _e4688 = select(select(-2i, -3i, _e4686), -1i, ((_e4651 >= 1e30f) && (_e4682 >= 1e30f)));
let _e4689 = select(_e4651, _e4682, _e4686);
let _e4704 = type_20(_e4612.member, _e4612.member_1, _e4612.member_2, _e4612.member_3, _e4612.member_4, _e4612.member_5, _e4612.member_6, _e4612.member_7, _e4612.member_8, _e4612.member_9, _e4612.member_10, _e4612.member_11, 0i, _e4612.member_13, _e4612.member_14);
let _e4719 = type_20(_e4704.member, _e4704.member_1, _e4704.member_2, _e4704.member_3, _e4704.member_4, _e4704.member_5, _e4704.member_6, _e4704.member_7, _e4704.member_8, _e4704.member_9, _e4704.member_10, _e4704.member_11, _e4704.member_12, _e4688, _e4704.member_14);
let _e4734 = type_20(_e4719.member, _e4719.member_1, _e4719.member_2, _e4719.member_3, _e4719.member_4, _e4719.member_5, _e4719.member_6, _e4719.member_7, _e4719.member_8, _e4719.member_9, _e4719.member_10, _e4719.member_11, _e4719.member_12, _e4719.member_13, _e4689);
let _e4736 = local_19;
let _e4739 = ((_e4466 & 2u) != 0u);
if (_e4521 && !(_e4739)) {
if (_e4688 == -1i) {
phi_6653_ = type_20(_e4734.member, _e4734.member_1, _e4734.member_2, _e4734.member_3, _e4734.member_4, _e4734.member_5, 1f, _e4734.member_7, _e4734.member_8, _e4734.member_9, _e4734.member_10, _e4734.member_11, _e4734.member_12, _e4734.member_13, _e4734.member_14);
} else {
let _e4815 = type_20(vec3<f32>((_e4612.member.x + (_e4612.member_1.x * _e4689)), (_e4612.member.y + (_e4612.member_1.y * _e4689)), (_e4612.member.z + (_e4612.member_1.z * _e4689))), _e4734.member_1, _e4734.member_2, _e4734.member_3, _e4734.member_4, _e4734.member_5, _e4734.member_6, _e4734.member_7, _e4734.member_8, _e4734.member_9, _e4734.member_10, _e4734.member_11, _e4734.member_12, _e4734.member_13, _e4734.member_14);
let _e4831 = type_20(_e4815.member, _e4815.member_1, _e4815.member_2, _e4815.member_3, _e4815.member_4, _e4815.member_5, _e4815.member_6, _e4815.member_7, _e4815.member_8, _e4815.member_9, _e4815.member_10, _e4815.member_11, _e4815.member_12, _e4815.member_13, (_e4689 - _e4689));
let _e4851 = type_20(_e4831.member, _e4831.member_1, _e4831.member_2, _e4831.member_3, _e4831.member_4, _e4831.member_5, _e4831.member_6, _e4831.member_7, _e4831.member_8, _e4831.member_9, (_e4612.member_10 + select(0f, _e4689, (_e4612.member_8 == 0f))), _e4831.member_11, _e4831.member_12, _e4831.member_13, _e4831.member_14);
phi_6653_ = type_20(_e4851.member, _e4851.member_1, _e4851.member_2, _e4851.member_3, _e4851.member_4, _e4851.member_5, 3f, _e4851.member_7, _e4851.member_8, _e4851.member_9, _e4851.member_10, _e4851.member_11, _e4851.member_12, _e4851.member_13, _e4851.member_14);
}
let _e4883 = phi_6653_;
phi_6674_ = _e4883;
} else {
let _e4746 = global_1.member.member_5;
if ((!(_e4521) && (_e4612.member_8 >= f32(bitcast<i32>(_e4746)))) && (select(_e4736, _e809.member_7, _e4394) != 16i)) {
phi_6673_ = type_20(_e4734.member, _e4734.member_1, _e4734.member_2, _e4734.member_3, _e4734.member_4, _e4734.member_5, 2f, _e4734.member_7, _e4734.member_8, _e4734.member_9, _e4734.member_10, _e4734.member_11, _e4734.member_12, _e4734.member_13, _e4734.member_14);
} else {
if _e4739 {
phi_6672_ = type_20(_e4734.member, _e4734.member_1, _e4734.member_2, _e4734.member_3, _e4734.member_4, _e4734.member_5, 4f, _e4734.member_7, _e4734.member_8, _e4734.member_9, _e4734.member_10, _e4734.member_11, _e4734.member_12, _e4734.member_13, _e4734.member_14);
} else {
phi_6672_ = _e4734;
}
let _e4769 = phi_6672_;
phi_6673_ = _e4769;
}
let _e4786 = phi_6673_;
phi_6674_ = _e4786;
}
let _e4885 = phi_6674_;
let _e4888 = local_20;
let _e4904 = type_20(_e4885.member, _e4885.member_1, _e4885.member_2, _e4885.member_3, _e4885.member_4, _e4885.member_5, _e4885.member_6, select(_e809.member_7, _e4888, !(_e4394)), _e4885.member_8, _e4885.member_9, _e4885.member_10, _e4885.member_11, _e4885.member_12, _e4885.member_13, _e4885.member_14);
let _e4919 = type_20(_e4904.member, _e4904.member_1, _e4904.member_2, _e4904.member_3, _e4037, _e4904.member_5, _e4904.member_6, _e4904.member_7, _e4904.member_8, _e4904.member_9, _e4904.member_10, _e4904.member_11, _e4904.member_12, _e4904.member_13, _e4904.member_14);
phi_6683_ = type_20(_e4919.member, _e4919.member_1, _e4919.member_2, _e4919.member_3, _e4919.member_4, 0f, _e4919.member_6, _e4919.member_7, _e4919.member_8, _e4919.member_9, _e4919.member_10, _e4919.member_11, _e4919.member_12, _e4919.member_13, _e4919.member_14);
}
let _e4936 = phi_6683_;
phi_6684_ = _e4936;
phi_6685_ = _e4063;
}
let _e4938 = phi_6684_;
let _e4940 = phi_6685_;
if (_e4940 && _e1019) {
let _e5410 = type_20(vec3<f32>((_e4938.member.x + (_e4938.member_1.x * _e4938.member_14)), (_e4938.member.y + (_e4938.member_1.y * _e4938.member_14)), (_e4938.member.z + (_e4938.member_1.z * _e4938.member_14))), _e4938.member_1, _e4938.member_2, _e4938.member_3, _e4938.member_4, _e4938.member_5, _e4938.member_6, _e4938.member_7, _e4938.member_8, _e4938.member_9, _e4938.member_10, _e4938.member_11, _e4938.member_12, _e4938.member_13, _e4938.member_14);
let _e5427 = type_20(_e5410.member, _e5410.member_1, _e5410.member_2, _e5410.member_3, _e5410.member_4, (_e4938.member_5 + _e4938.member_14), _e5410.member_6, _e5410.member_7, _e5410.member_8, _e5410.member_9, _e5410.member_10, _e5410.member_11, _e5410.member_12, _e5410.member_13, _e5410.member_14);
let _e5443 = type_20(_e5427.member, _e5427.member_1, _e5427.member_2, _e5427.member_3, _e5427.member_4, _e5427.member_5, _e5427.member_6, _e5427.member_7, _e5427.member_8, _e5427.member_9, _e5427.member_10, _e5427.member_11, _e5427.member_12, _e5427.member_13, (_e4938.member_14 - _e4938.member_14));
let _e5463 = type_20(_e5443.member, _e5443.member_1, _e5443.member_2, _e5443.member_3, _e5443.member_4, _e5443.member_5, _e5443.member_6, _e5443.member_7, _e5443.member_8, _e5443.member_9, (_e4938.member_10 + select(0f, _e4938.member_14, (_e4938.member_8 == 0f))), _e5443.member_11, _e5443.member_12, _e5443.member_13, _e5443.member_14);
if (_e809.member_7 != 16i) {
let _e5481 = type_20(_e5463.member, _e5463.member_1, _e5463.member_2, _e5463.member_3, _e5463.member_4, _e5463.member_5, _e5463.member_6, _e5463.member_7, _e5463.member_8, (_e4938.member_9 + _e4938.member_14), _e5463.member_10, _e5463.member_11, _e5463.member_12, _e5463.member_13, _e5463.member_14);
let _e5482 = (_e809.member_7 * 4i);
let _e5483 = (_e5482 + 1i);
let _e5485 = (bitcast<i32>(_e94) - 1i);
let _e5487 = select(_e5485, _e5483, (_e5483 < _e5485));
let _e5493 = global_2.member[bitcast<u32>(select(0i, _e5487, (_e5487 > 0i)))];
let _e5495 = -((_e5493 * _e4938.member_14));
let _e5497 = select(-87f, _e5495, (_e5495 > -87f));
let _e5499 = select(88f, _e5497, (_e5497 < 88f));
let _e5501 = ((_e5499 * 1.442695f) + 0.5f);
let _e5503 = select(-127f, _e5501, (_e5501 > -127f));
let _e5505 = select(128f, _e5503, (_e5503 < 128f));
let _e5512 = select(0i, select(select(i32(_e5505), i32(-2147483648), (_e5505 < -2147483600f)), 2147483647i, (_e5505 > 2147483500f)), (_e5505 == _e5505));
let _e5516 = (_e5512 - select(0i, 1i, (_e5505 < f32(_e5512))));
let _e5517 = f32(_e5516);
let _e5521 = ((_e5499 - (_e5517 * 0.6933594f)) - (_e5517 * -2.1219444e-4f));
let _e5545 = (_e5482 + 2i);
let _e5547 = select(_e5485, _e5545, (_e5545 < _e5485));
let _e5553 = global_2.member[bitcast<u32>(select(0i, _e5547, (_e5547 > 0i)))];
let _e5555 = -((_e5553 * _e4938.member_14));
let _e5557 = select(-87f, _e5555, (_e5555 > -87f));
let _e5559 = select(88f, _e5557, (_e5557 < 88f));
let _e5561 = ((_e5559 * 1.442695f) + 0.5f);
let _e5563 = select(-127f, _e5561, (_e5561 > -127f));
let _e5565 = select(128f, _e5563, (_e5563 < 128f));
let _e5572 = select(0i, select(select(i32(_e5565), i32(-2147483648), (_e5565 < -2147483600f)), 2147483647i, (_e5565 > 2147483500f)), (_e5565 == _e5565));
let _e5576 = (_e5572 - select(0i, 1i, (_e5565 < f32(_e5572))));
let _e5577 = f32(_e5576);
let _e5581 = ((_e5559 - (_e5577 * 0.6933594f)) - (_e5577 * -2.1219444e-4f));
let _e5605 = (_e5482 + 3i);
let _e5607 = select(_e5485, _e5605, (_e5605 < _e5485));
let _e5613 = global_2.member[bitcast<u32>(select(0i, _e5607, (_e5607 > 0i)))];
let _e5615 = -((_e5613 * _e4938.member_14));
let _e5617 = select(-87f, _e5615, (_e5615 > -87f));
let _e5619 = select(88f, _e5617, (_e5617 < 88f));
let _e5621 = ((_e5619 * 1.442695f) + 0.5f);
let _e5623 = select(-127f, _e5621, (_e5621 > -127f));
let _e5625 = select(128f, _e5623, (_e5623 < 128f));
let _e5632 = select(0i, select(select(i32(_e5625), i32(-2147483648), (_e5625 < -2147483600f)), 2147483647i, (_e5625 > 2147483500f)), (_e5625 == _e5625));
let _e5636 = (_e5632 - select(0i, 1i, (_e5625 < f32(_e5632))));
let _e5637 = f32(_e5636);
let _e5641 = ((_e5619 - (_e5637 * 0.6933594f)) - (_e5637 * -2.1219444e-4f));
phi_6975_ = type_20(_e5481.member, _e5481.member_1, vec3<f32>((_e4938.member_2.x * ((1f + (_e5521 * (1f + (_e5521 * (0.5f + (_e5521 * (0.16666667f + (_e5521 * (0.041666668f + (_e5521 * (0.008333334f + (_e5521 * (0.001388889f + (_e5521 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5516 + 127i)) << bitcast<u32>(23i))))), (_e4938.member_2.y * ((1f + (_e5581 * (1f + (_e5581 * (0.5f + (_e5581 * (0.16666667f + (_e5581 * (0.041666668f + (_e5581 * (0.008333334f + (_e5581 * (0.001388889f + (_e5581 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5576 + 127i)) << bitcast<u32>(23i))))), (_e4938.member_2.z * ((1f + (_e5641 * (1f + (_e5641 * (0.5f + (_e5641 * (0.16666667f + (_e5641 * (0.041666668f + (_e5641 * (0.008333334f + (_e5641 * (0.001388889f + (_e5641 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5636 + 127i)) << bitcast<u32>(23i)))))), _e5481.member_3, _e5481.member_4, _e5481.member_5, _e5481.member_6, _e5481.member_7, _e5481.member_8, _e5481.member_9, _e5481.member_10, _e5481.member_11, _e5481.member_12, _e5481.member_13, _e5481.member_14);
} else {
phi_6975_ = _e5463;
}
let _e5682 = phi_6975_;
phi_7569_ = type_20(_e5682.member, _e5682.member_1, _e5682.member_2, _e5682.member_3, _e5682.member_4, _e5682.member_5, 3f, _e5682.member_7, _e5682.member_8, _e5682.member_9, _e5682.member_10, _e5682.member_11, _e5682.member_12, _e5682.member_13, _e5682.member_14);
} else {
if _e4940 {
let _e4973 = type_20(vec3<f32>((_e4938.member.x + (_e4938.member_1.x * _e1020)), (_e4938.member.y + (_e4938.member_1.y * _e1020)), (_e4938.member.z + (_e4938.member_1.z * _e1020))), _e4938.member_1, _e4938.member_2, _e4938.member_3, _e4938.member_4, _e4938.member_5, _e4938.member_6, _e4938.member_7, _e4938.member_8, _e4938.member_9, _e4938.member_10, _e4938.member_11, _e4938.member_12, _e4938.member_13, _e4938.member_14);
let _e4990 = type_20(_e4973.member, _e4973.member_1, _e4973.member_2, _e4973.member_3, _e4973.member_4, (_e4938.member_5 + _e1020), _e4973.member_6, _e4973.member_7, _e4973.member_8, _e4973.member_9, _e4973.member_10, _e4973.member_11, _e4973.member_12, _e4973.member_13, _e4973.member_14);
let _e5007 = type_20(_e4990.member, _e4990.member_1, _e4990.member_2, _e4990.member_3, _e4990.member_4, _e4990.member_5, _e4990.member_6, _e4990.member_7, _e4990.member_8, _e4990.member_9, _e4990.member_10, _e4990.member_11, _e4990.member_12, _e4990.member_13, (_e4938.member_14 - _e1020));
let _e5027 = type_20(_e5007.member, _e5007.member_1, _e5007.member_2, _e5007.member_3, _e5007.member_4, _e5007.member_5, _e5007.member_6, _e5007.member_7, _e5007.member_8, _e5007.member_9, (_e4938.member_10 + select(0f, _e1020, (_e4938.member_8 == 0f))), _e5007.member_11, _e5007.member_12, _e5007.member_13, _e5007.member_14);
if (_e809.member_7 != 16i) {
let _e5045 = type_20(_e5027.member, _e5027.member_1, _e5027.member_2, _e5027.member_3, _e5027.member_4, _e5027.member_5, _e5027.member_6, _e5027.member_7, _e5027.member_8, (_e4938.member_9 + _e1020), _e5027.member_10, _e5027.member_11, _e5027.member_12, _e5027.member_13, _e5027.member_14);
let _e5046 = (_e809.member_7 * 4i);
let _e5047 = (_e5046 + 1i);
let _e5049 = (bitcast<i32>(_e94) - 1i);
let _e5051 = select(_e5049, _e5047, (_e5047 < _e5049));
let _e5057 = global_2.member[bitcast<u32>(select(0i, _e5051, (_e5051 > 0i)))];
let _e5059 = -((_e5057 * _e1020));
let _e5061 = select(-87f, _e5059, (_e5059 > -87f));
let _e5063 = select(88f, _e5061, (_e5061 < 88f));
let _e5065 = ((_e5063 * 1.442695f) + 0.5f);
let _e5067 = select(-127f, _e5065, (_e5065 > -127f));
let _e5069 = select(128f, _e5067, (_e5067 < 128f));
let _e5076 = select(0i, select(select(i32(_e5069), i32(-2147483648), (_e5069 < -2147483600f)), 2147483647i, (_e5069 > 2147483500f)), (_e5069 == _e5069));
let _e5080 = (_e5076 - select(0i, 1i, (_e5069 < f32(_e5076))));
let _e5081 = f32(_e5080);
let _e5085 = ((_e5063 - (_e5081 * 0.6933594f)) - (_e5081 * -2.1219444e-4f));
let _e5109 = (_e5046 + 2i);
let _e5111 = select(_e5049, _e5109, (_e5109 < _e5049));
let _e5117 = global_2.member[bitcast<u32>(select(0i, _e5111, (_e5111 > 0i)))];
let _e5119 = -((_e5117 * _e1020));
let _e5121 = select(-87f, _e5119, (_e5119 > -87f));
let _e5123 = select(88f, _e5121, (_e5121 < 88f));
let _e5125 = ((_e5123 * 1.442695f) + 0.5f);
let _e5127 = select(-127f, _e5125, (_e5125 > -127f));
let _e5129 = select(128f, _e5127, (_e5127 < 128f));
let _e5136 = select(0i, select(select(i32(_e5129), i32(-2147483648), (_e5129 < -2147483600f)), 2147483647i, (_e5129 > 2147483500f)), (_e5129 == _e5129));
let _e5140 = (_e5136 - select(0i, 1i, (_e5129 < f32(_e5136))));
let _e5141 = f32(_e5140);
let _e5145 = ((_e5123 - (_e5141 * 0.6933594f)) - (_e5141 * -2.1219444e-4f));
let _e5169 = (_e5046 + 3i);
let _e5171 = select(_e5049, _e5169, (_e5169 < _e5049));
let _e5177 = global_2.member[bitcast<u32>(select(0i, _e5171, (_e5171 > 0i)))];
let _e5179 = -((_e5177 * _e1020));
let _e5181 = select(-87f, _e5179, (_e5179 > -87f));
let _e5183 = select(88f, _e5181, (_e5181 < 88f));
let _e5185 = ((_e5183 * 1.442695f) + 0.5f);
let _e5187 = select(-127f, _e5185, (_e5185 > -127f));
let _e5189 = select(128f, _e5187, (_e5187 < 128f));
let _e5196 = select(0i, select(select(i32(_e5189), i32(-2147483648), (_e5189 < -2147483600f)), 2147483647i, (_e5189 > 2147483500f)), (_e5189 == _e5189));
let _e5200 = (_e5196 - select(0i, 1i, (_e5189 < f32(_e5196))));
let _e5201 = f32(_e5200);
let _e5205 = ((_e5183 - (_e5201 * 0.6933594f)) - (_e5201 * -2.1219444e-4f));
phi_7264_ = type_20(_e5045.member, _e5045.member_1, vec3<f32>((_e4938.member_2.x * ((1f + (_e5085 * (1f + (_e5085 * (0.5f + (_e5085 * (0.16666667f + (_e5085 * (0.041666668f + (_e5085 * (0.008333334f + (_e5085 * (0.001388889f + (_e5085 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5080 + 127i)) << bitcast<u32>(23i))))), (_e4938.member_2.y * ((1f + (_e5145 * (1f + (_e5145 * (0.5f + (_e5145 * (0.16666667f + (_e5145 * (0.041666668f + (_e5145 * (0.008333334f + (_e5145 * (0.001388889f + (_e5145 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5140 + 127i)) << bitcast<u32>(23i))))), (_e4938.member_2.z * ((1f + (_e5205 * (1f + (_e5205 * (0.5f + (_e5205 * (0.16666667f + (_e5205 * (0.041666668f + (_e5205 * (0.008333334f + (_e5205 * (0.001388889f + (_e5205 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e5200 + 127i)) << bitcast<u32>(23i)))))), _e5045.member_3, _e5045.member_4, _e5045.member_5, _e5045.member_6, _e5045.member_7, _e5045.member_8, _e5045.member_9, _e5045.member_10, _e5045.member_11, _e5045.member_12, _e5045.member_13, _e5045.member_14);
} else {
phi_7264_ = _e5027;
}
let _e5246 = phi_7264_;
let _e5249 = local_21;
if (((_e870 <= 0f) && (_e5249 == 16i)) && (_e809.member_7 == 16i)) {
if (_e5246.member_13 == -1i) {
phi_7566_ = type_20(_e5246.member, _e5246.member_1, _e5246.member_2, _e5246.member_3, _e5246.member_4, _e5246.member_5, 1f, _e5246.member_7, _e5246.member_8, _e5246.member_9, _e5246.member_10, _e5246.member_11, _e5246.member_12, _e5246.member_13, _e5246.member_14);
} else {
let _e5288 = type_20(vec3<f32>((_e5246.member.x + (_e5246.member_1.x * _e5246.member_14)), (_e5246.member.y + (_e5246.member_1.y * _e5246.member_14)), (_e5246.member.z + (_e5246.member_1.z * _e5246.member_14))), _e5246.member_1, _e5246.member_2, _e5246.member_3, _e5246.member_4, _e5246.member_5, _e5246.member_6, _e5246.member_7, _e5246.member_8, _e5246.member_9, _e5246.member_10, _e5246.member_11, _e5246.member_12, _e5246.member_13, _e5246.member_14);
let _e5305 = type_20(_e5288.member, _e5288.member_1, _e5288.member_2, _e5288.member_3, _e5288.member_4, (_e5246.member_5 + _e5246.member_14), _e5288.member_6, _e5288.member_7, _e5288.member_8, _e5288.member_9, _e5288.member_10, _e5288.member_11, _e5288.member_12, _e5288.member_13, _e5288.member_14);
let _e5321 = type_20(_e5305.member, _e5305.member_1, _e5305.member_2, _e5305.member_3, _e5305.member_4, _e5305.member_5, _e5305.member_6, _e5305.member_7, _e5305.member_8, _e5305.member_9, _e5305.member_10, _e5305.member_11, _e5305.member_12, _e5305.member_13, (_e5246.member_14 - _e5246.member_14));
let _e5341 = type_20(_e5321.member, _e5321.member_1, _e5321.member_2, _e5321.member_3, _e5321.member_4, _e5321.member_5, _e5321.member_6, _e5321.member_7, _e5321.member_8, _e5321.member_9, (_e5246.member_10 + select(0f, _e5246.member_14, (_e5246.member_8 == 0f))), _e5321.member_11, _e5321.member_12, _e5321.member_13, _e5321.member_14);
phi_7566_ = type_20(_e5341.member, _e5341.member_1, _e5341.member_2, _e5341.member_3, _e5341.member_4, _e5341.member_5, 3f, _e5341.member_7, _e5341.member_8, _e5341.member_9, _e5341.member_10, _e5341.member_11, _e5341.member_12, _e5341.member_13, _e5341.member_14);
}
let _e5373 = phi_7566_;
phi_7567_ = _e5373;
} else {
phi_7567_ = _e5246;
}
let _e5375 = phi_7567_;
phi_7568_ = _e5375;
} else {
phi_7568_ = _e4938;
}
let _e5377 = phi_7568_;
phi_7569_ = _e5377;
}
let _e5699 = phi_7569_;
phi_1189_ = _e5699;
phi_1192_ = (_e811 + 1i);
} else {
phi_1189_ = type_20();
phi_1192_ = i32();
}
let _e5701 = phi_1189_;
let _e5703 = phi_1192_;
continue;
continuing {
phi_1188_ = _e5701;
phi_1191_ = _e5703;
break if !(_e815);
}
}
let _e5706 = local_22;
let _e5710 = local_23;
let _e5714 = local_24;
let _e5718 = local_25;
let _e5722 = local_26;
let _e5726 = local_27;
let _e5730 = local_28;
let _e5734 = local_29;
let _e5738 = local_30;
let _e5742 = local_31;
let _e5746 = local_32;
let _e5750 = local_33;
let _e5754 = local_34;
let _e5758 = local_35;
let _e5762 = local_36;
let _e5766 = local_37;
let _e5769 = local_38;
let _e5773 = local_39;
let _e5776 = local_40;
let _e5779 = local_41;
let _e5782 = local_42;
let _e5785 = local_43;
let _e5789 = local_44;
let _e5793 = local_45;
global_3.member[_e110] = _e5706.member.x;
global_3.member[_e122] = _e5710.member.y;
global_3.member[_e133] = _e5714.member.z;
global_3.member[_e144] = _e5718.member_1.x;
global_3.member[_e155] = _e5722.member_1.y;
global_3.member[_e166] = _e5726.member_1.z;
global_3.member[_e177] = _e5730.member_2.x;
global_3.member[_e188] = _e5734.member_2.y;
global_3.member[_e199] = _e5738.member_2.z;
global_3.member[_e210] = _e5742.member_3.x;
global_3.member[_e221] = _e5746.member_3.y;
global_3.member[_e232] = _e5750.member_3.z;
global_3.member[_e243] = _e5754.member_4.x;
global_3.member[_e254] = _e5758.member_4.y;
global_3.member[_e265] = _e5762.member_4.z;
global_3.member[_e276] = _e5766.member_5;
let _e5830 = local_46;
global_3.member[_e287] = _e5830;
global_3.member[_e298] = f32(_e5769.member_7);
global_3.member[_e309] = _e5773.member_8;
global_3.member[_e320] = _e5776.member_9;
global_3.member[_e331] = _e5779.member_10;
global_3.member[_e342] = _e5782.member_11;
global_3.member[_e353] = f32(_e5785.member_12);
global_3.member[_e364] = f32(_e5789.member_13);
global_3.member[_e375] = _e5793.member_14;
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
