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
struct type_13 {
member: array<f32>,
}
struct type_16 {
member: u32,
member_1: u32,
}
struct type_17 {
member: u32,
member_1: type_5,
member_2: type_5,
member_3: type_5,
member_4: type_5,
member_5: f32,
member_6: f32,
member_7: f32,
member_8: f32,
}
struct type_18 {
member: f32,
member_1: f32,
member_2: f32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
member_11: u32,
}
struct type_19 {
member: type_5,
member_1: type_5,
member_2: f32,
member_3: u32,
member_4: type_5,
member_5: type_5,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
member_10: u32,
}
struct type_20 {
member: f32,
member_1: u32,
member_2: u32,
member_3: u32,
member_4: u32,
member_5: u32,
member_6: u32,
member_7: u32,
member_8: u32,
member_9: u32,
}
struct type_21 {
member: type_2,
member_1: type_16,
member_2: type_4,
member_3: type_5,
member_4: type_5,
member_5: type_5,
member_6: type_5,
member_7: f32,
member_8: type_5,
member_9: type_5,
member_10: type_11,
member_11: type_17,
member_12: type_18,
member_13: type_19,
member_14: type_9,
member_15: type_6,
member_16: type_5,
member_17: u32,
member_18: type_20,
}
struct type_22 {
member: type_21,
}
struct type_23 {
member: i32,
member_1: i32,
}
struct type_26 {
member: array<atomic<u32>>,
}
var<private> global: vec3<u32>;
@group(0) @binding(0)
var<storage> global_1: type_22;
@group(0) @binding(5)
var<storage> global_2: type_13;
@group(0) @binding(1)
var<storage> global_3: type_13;
@group(0) @binding(2)
var<storage> global_4: type_13;
@group(0) @binding(3)
var<storage> global_5: type_13;
@group(0) @binding(4)
var<storage> global_6: type_13;
@group(0) @binding(6)
var<storage> global_7: type_13;
@group(0) @binding(7)
var<storage, read_write> global_8: type_26;
fn function_() {
var local: i32;
var local_1: i32;
var local_2: i32;
var local_3: i32;
var local_4: i32;
var local_5: i32;
var local_6: i32;
var local_7: i32;
var local_8: i32;
var local_9: i32;
var local_10: i32;
var local_11: i32;
var local_12: i32;
var local_13: i32;
var local_14: i32;
var local_15: i32;
var local_16: i32;
var local_17: i32;
var local_18: i32;
var local_19: i32;
var local_20: i32;
var local_21: i32;
var local_22: i32;
var local_23: i32;
var local_24: i32;
var local_25: i32;
var local_26: i32;
var local_27: i32;
var local_28: i32;
var local_29: i32;
var local_30: i32;
var local_31: i32;
var local_32: i32;
var local_33: i32;
var local_34: i32;
var local_35: i32;
var local_36: i32;
var local_37: i32;
var local_38: i32;
var local_39: i32;
var local_40: i32;
var local_41: i32;
var local_42: i32;
var local_43: i32;
var local_44: i32;
var local_45: i32;
var local_46: i32;
var local_47: i32;
var local_48: i32;
var local_49: i32;
var local_50: i32;
var local_51: i32;
var local_52: i32;
var local_53: i32;
var local_54: i32;
var local_55: i32;
var local_56: i32;
var local_57: i32;
var local_58: i32;
var local_59: i32;
var local_60: i32;
var local_61: i32;
var local_62: i32;
var local_63: i32;
var local_64: i32;
var local_65: i32;
var local_66: i32;
var local_67: i32;
var local_68: i32;
var local_69: i32;
var local_70: i32;
var local_71: i32;
var local_72: i32;
var local_73: i32;
var local_74: i32;
var local_75: i32;
var local_76: i32;
var local_77: i32;
var local_78: i32;
var local_79: i32;
var local_80: i32;
var local_81: i32;
var local_82: i32;
var local_83: i32;
var local_84: i32;
var local_85: i32;
var local_86: i32;
var local_87: i32;
var local_88: i32;
var local_89: i32;
var local_90: i32;
var local_91: i32;
var local_92: i32;
var local_93: i32;
var local_94: i32;
var local_95: i32;
var local_96: i32;
var local_97: i32;
var local_98: i32;
var local_99: i32;
var local_100: i32;
var local_101: i32;
var local_102: i32;
var local_103: i32;
var local_104: f32;
var local_105: i32;
var local_106: i32;
var local_107: i32;
var local_108: i32;
var local_109: i32;
var local_110: i32;
var local_111: i32;
var local_112: i32;
var local_113: i32;
var local_114: i32;
var local_115: i32;
var local_116: i32;
var local_117: i32;
var local_118: i32;
var local_119: i32;
var local_120: i32;
var local_121: i32;
var local_122: f32;
var local_123: i32;
var local_124: i32;
var local_125: i32;
var local_126: i32;
var local_127: i32;
var local_128: i32;
var local_129: i32;
var local_130: i32;
var local_131: i32;
var local_132: f32;
var local_133: i32;
var local_134: i32;
var local_135: i32;
var local_136: i32;
var local_137: i32;
var local_138: i32;
var local_139: i32;
var local_140: i32;
var local_141: i32;
var local_142: f32;
var local_143: i32;
var local_144: i32;
var local_145: i32;
var local_146: i32;
var local_147: i32;
var local_148: i32;
var local_149: i32;
var local_150: i32;
var local_151: i32;
var local_152: i32;
var local_153: i32;
var local_154: i32;
var local_155: i32;
var local_156: i32;
var local_157: i32;
var local_158: i32;
var local_159: i32;
var local_160: i32;
var local_161: i32;
var local_162: i32;
var local_163: i32;
var local_164: i32;
var local_165: i32;
var local_166: i32;
var local_167: i32;
var local_168: i32;
var local_169: i32;
var local_170: i32;
var local_171: i32;
var local_172: i32;
var local_173: i32;
var local_174: i32;
var local_175: i32;
var local_176: i32;
var local_177: i32;
var local_178: f32;
var local_179: i32;
var local_180: i32;
var local_181: i32;
var local_182: i32;
var local_183: i32;
var local_184: i32;
var local_185: i32;
var local_186: i32;
var local_187: i32;
var local_188: i32;
var local_189: i32;
var local_190: i32;
var local_191: i32;
var local_192: i32;
var local_193: i32;
var local_194: i32;
var local_195: i32;
var local_196: f32;
var local_197: i32;
var local_198: i32;
var local_199: i32;
var local_200: i32;
var local_201: i32;
var local_202: i32;
var local_203: i32;
var local_204: i32;
var local_205: i32;
var local_206: f32;
var local_207: i32;
var local_208: i32;
var local_209: i32;
var local_210: i32;
var local_211: i32;
var local_212: i32;
var local_213: i32;
var local_214: i32;
var local_215: i32;
var local_216: i32;
var local_217: i32;
var local_218: i32;
var local_219: i32;
var local_220: i32;
var local_221: i32;
var local_222: i32;
var local_223: i32;
var local_224: i32;
var local_225: i32;
var local_226: i32;
var local_227: i32;
var phi_699_: bool;
var phi_700_: bool;
var phi_701_: bool;
var phi_1081_: type_23;
var phi_1793_: f32;
var phi_1796_: u32;
var phi_1794_: f32;
var phi_1797_: u32;
var local_228: u32;
var phi_1826_: f32;
var phi_1829_: u32;
var phi_1827_: f32;
var phi_1830_: u32;
var phi_1841_: u32;
var phi_1896_: f32;
var phi_1899_: u32;
var phi_1897_: f32;
var phi_1900_: u32;
var local_229: u32;
var phi_1929_: f32;
var phi_1932_: u32;
var phi_1930_: f32;
var phi_1933_: u32;
var phi_1944_: u32;
var phi_1945_: u32;
var phi_2000_: f32;
var phi_2003_: u32;
var phi_2001_: f32;
var phi_2004_: u32;
var local_230: u32;
var phi_2033_: f32;
var phi_2036_: u32;
var phi_2034_: f32;
var phi_2037_: u32;
var phi_2048_: u32;
var phi_2049_: u32;
var phi_2095_: type_23;
var phi_2170_: i32;
var phi_2208_: i32;
var phi_2362_: i32;
var phi_2467_: type_23;
var phi_2880_: f32;
var phi_3007_: f32;
var phi_3155_: i32;
var phi_3168_: i32;
var phi_3182_: i32;
var phi_3617_: type_23;
var phi_3850_: u32;
var phi_3880_: u32;
var phi_3910_: u32;
var phi_2363_: i32;
var phi_2209_: i32;
var phi_3959_: i32;
var phi_4113_: i32;
var phi_4218_: type_23;
var phi_4631_: f32;
var phi_4758_: f32;
var phi_4906_: i32;
var phi_4919_: i32;
var phi_4933_: i32;
var phi_5394_: type_23;
var phi_5472_: i32;
var phi_5483_: i32;
var phi_5511_: type_23;
var phi_5560_: u32;
var phi_5561_: u32;
var phi_5562_: u32;
var phi_6109_: i32;
var phi_6120_: i32;
var phi_6148_: type_23;
var phi_6197_: u32;
var phi_6198_: u32;
var phi_6199_: u32;
var phi_6746_: i32;
var phi_6757_: i32;
var phi_6785_: type_23;
var phi_6834_: u32;
var phi_6835_: u32;
var phi_6836_: u32;
var phi_7383_: i32;
var phi_7394_: i32;
var phi_7422_: type_23;
var phi_7471_: u32;
var phi_7472_: u32;
var phi_7473_: u32;
var phi_8029_: type_23;
var phi_8262_: u32;
var phi_8292_: u32;
var phi_8322_: u32;
var phi_4114_: i32;
var phi_3960_: i32;
var phi_8367_: i32;
var phi_8521_: i32;
var phi_8626_: type_23;
var phi_9039_: f32;
var phi_9166_: f32;
var phi_9314_: i32;
var phi_9327_: i32;
var phi_9341_: i32;
var phi_9800_: type_23;
var phi_9878_: i32;
var phi_9889_: i32;
var phi_9917_: type_23;
var phi_9966_: u32;
var phi_9967_: u32;
var phi_9968_: u32;
var phi_10515_: i32;
var phi_10526_: i32;
var phi_10554_: type_23;
var phi_10603_: u32;
var phi_10604_: u32;
var phi_10605_: u32;
var phi_11152_: i32;
var phi_11163_: i32;
var phi_11191_: type_23;
var phi_11240_: u32;
var phi_11241_: u32;
var phi_11242_: u32;
var phi_11789_: i32;
var phi_11800_: i32;
var phi_11828_: type_23;
var phi_11877_: u32;
var phi_11878_: u32;
var phi_11879_: u32;
var phi_12444_: type_23;
var phi_12522_: i32;
var phi_12533_: i32;
var phi_12561_: type_23;
var phi_12610_: u32;
var phi_12611_: u32;
var phi_12612_: u32;
var phi_13159_: i32;
var phi_13170_: i32;
var phi_13198_: type_23;
var phi_13247_: u32;
var phi_13248_: u32;
var phi_13249_: u32;
var phi_13796_: i32;
var phi_13807_: i32;
var phi_13835_: type_23;
var phi_13884_: u32;
var phi_13885_: u32;
var phi_13886_: u32;
var phi_14433_: i32;
var phi_14444_: i32;
var phi_14472_: type_23;
var phi_14521_: u32;
var phi_14522_: u32;
var phi_14523_: u32;
var phi_15088_: type_23;
var phi_15166_: i32;
var phi_15177_: i32;
var phi_15205_: type_23;
var phi_15254_: u32;
var phi_15255_: u32;
var phi_15256_: u32;
var phi_15803_: i32;
var phi_15814_: i32;
var phi_15842_: type_23;
var phi_15891_: u32;
var phi_15892_: u32;
var phi_15893_: u32;
var phi_16440_: i32;
var phi_16451_: i32;
var phi_16479_: type_23;
var phi_16528_: u32;
var phi_16529_: u32;
var phi_16530_: u32;
var phi_17077_: i32;
var phi_17088_: i32;
var phi_17116_: type_23;
var phi_17165_: u32;
var phi_17166_: u32;
var phi_17167_: u32;
var phi_17723_: type_23;
var phi_17956_: u32;
var phi_17986_: u32;
var phi_18016_: u32;
var phi_8522_: i32;
var phi_8368_: i32;
var phi_18082_: type_23;
var phi_18157_: i32;
var phi_18161_: type_23;
var phi_18164_: i32;
var phi_18315_: type_23;
var phi_18318_: i32;
var phi_18448_: type_23;
var phi_18497_: u32;
var phi_18498_: u32;
var phi_18499_: u32;
var phi_18625_: i32;
var phi_18636_: i32;
var phi_19045_: f32;
var phi_19172_: f32;
var phi_19320_: i32;
var phi_19333_: i32;
var phi_19347_: i32;
var phi_19803_: type_23;
var phi_20000_: u32;
var phi_20001_: u32;
var phi_20002_: u32;
var phi_20036_: u32;
var phi_20066_: u32;
var phi_20096_: u32;
var phi_20133_: type_23;
var phi_18316_: type_23;
var phi_18319_: i32;
var phi_18162_: type_23;
var phi_18165_: i32;
var local_231: type_23;
var local_232: type_23;
var phi_20150_: i32;
var phi_20185_: i32;
var phi_20339_: i32;
var phi_20444_: type_23;
var phi_20857_: f32;
var phi_20984_: f32;
var phi_21132_: i32;
var phi_21145_: i32;
var phi_21159_: i32;
var phi_21594_: type_23;
var phi_21827_: u32;
var phi_21857_: u32;
var phi_21887_: u32;
var phi_20340_: i32;
var phi_20186_: i32;
var phi_21936_: i32;
var phi_22090_: i32;
var phi_22195_: type_23;
var phi_22608_: f32;
var phi_22735_: f32;
var phi_22883_: i32;
var phi_22896_: i32;
var phi_22910_: i32;
var phi_23371_: type_23;
var phi_23449_: i32;
var phi_23460_: i32;
var phi_23488_: type_23;
var phi_23537_: u32;
var phi_23538_: u32;
var phi_23539_: u32;
var phi_24086_: i32;
var phi_24097_: i32;
var phi_24125_: type_23;
var phi_24174_: u32;
var phi_24175_: u32;
var phi_24176_: u32;
var phi_24723_: i32;
var phi_24734_: i32;
var phi_24762_: type_23;
var phi_24811_: u32;
var phi_24812_: u32;
var phi_24813_: u32;
var phi_25360_: i32;
var phi_25371_: i32;
var phi_25399_: type_23;
var phi_25448_: u32;
var phi_25449_: u32;
var phi_25450_: u32;
var phi_26006_: type_23;
var phi_26239_: u32;
var phi_26269_: u32;
var phi_26299_: u32;
var phi_22091_: i32;
var phi_21937_: i32;
var phi_26344_: i32;
var phi_26498_: i32;
var phi_26603_: type_23;
var phi_27016_: f32;
var phi_27143_: f32;
var phi_27291_: i32;
var phi_27304_: i32;
var phi_27318_: i32;
var phi_27777_: type_23;
var phi_27855_: i32;
var phi_27866_: i32;
var phi_27894_: type_23;
var phi_27943_: u32;
var phi_27944_: u32;
var phi_27945_: u32;
var phi_28492_: i32;
var phi_28503_: i32;
var phi_28531_: type_23;
var phi_28580_: u32;
var phi_28581_: u32;
var phi_28582_: u32;
var phi_29129_: i32;
var phi_29140_: i32;
var phi_29168_: type_23;
var phi_29217_: u32;
var phi_29218_: u32;
var phi_29219_: u32;
var phi_29766_: i32;
var phi_29777_: i32;
var phi_29805_: type_23;
var phi_29854_: u32;
var phi_29855_: u32;
var phi_29856_: u32;
var phi_30421_: type_23;
var phi_30499_: i32;
var phi_30510_: i32;
var phi_30538_: type_23;
var phi_30587_: u32;
var phi_30588_: u32;
var phi_30589_: u32;
var phi_31136_: i32;
var phi_31147_: i32;
var phi_31175_: type_23;
var phi_31224_: u32;
var phi_31225_: u32;
var phi_31226_: u32;
var phi_31773_: i32;
var phi_31784_: i32;
var phi_31812_: type_23;
var phi_31861_: u32;
var phi_31862_: u32;
var phi_31863_: u32;
var phi_32410_: i32;
var phi_32421_: i32;
var phi_32449_: type_23;
var phi_32498_: u32;
var phi_32499_: u32;
var phi_32500_: u32;
var phi_33065_: type_23;
var phi_33143_: i32;
var phi_33154_: i32;
var phi_33182_: type_23;
var phi_33231_: u32;
var phi_33232_: u32;
var phi_33233_: u32;
var phi_33780_: i32;
var phi_33791_: i32;
var phi_33819_: type_23;
var phi_33868_: u32;
var phi_33869_: u32;
var phi_33870_: u32;
var phi_34417_: i32;
var phi_34428_: i32;
var phi_34456_: type_23;
var phi_34505_: u32;
var phi_34506_: u32;
var phi_34507_: u32;
var phi_35054_: i32;
var phi_35065_: i32;
var phi_35093_: type_23;
var phi_35142_: u32;
var phi_35143_: u32;
var phi_35144_: u32;
var phi_35700_: type_23;
var phi_35933_: u32;
var phi_35963_: u32;
var phi_35993_: u32;
var phi_26499_: i32;
var phi_26345_: i32;
var phi_36060_: type_23;
var phi_36135_: i32;
var phi_36173_: i32;
var phi_36327_: i32;
var phi_36432_: type_23;
var phi_36984_: type_23;
var phi_37217_: u32;
var phi_37247_: u32;
var phi_37277_: u32;
var phi_36328_: i32;
var phi_36174_: i32;
var phi_37326_: i32;
var phi_37480_: i32;
var phi_37585_: type_23;
var phi_38163_: type_23;
var phi_38241_: i32;
var phi_38252_: i32;
var phi_38280_: type_23;
var phi_38329_: u32;
var phi_38330_: u32;
var phi_38331_: u32;
var phi_38878_: i32;
var phi_38889_: i32;
var phi_38917_: type_23;
var phi_38966_: u32;
var phi_38967_: u32;
var phi_38968_: u32;
var phi_39515_: i32;
var phi_39526_: i32;
var phi_39554_: type_23;
var phi_39603_: u32;
var phi_39604_: u32;
var phi_39605_: u32;
var phi_40152_: i32;
var phi_40163_: i32;
var phi_40191_: type_23;
var phi_40240_: u32;
var phi_40241_: u32;
var phi_40242_: u32;
var phi_40798_: type_23;
var phi_41031_: u32;
var phi_41061_: u32;
var phi_41091_: u32;
var phi_37481_: i32;
var phi_37327_: i32;
var phi_41136_: i32;
var phi_41290_: i32;
var phi_41395_: type_23;
var phi_41971_: type_23;
var phi_42049_: i32;
var phi_42060_: i32;
var phi_42088_: type_23;
var phi_42137_: u32;
var phi_42138_: u32;
var phi_42139_: u32;
var phi_42686_: i32;
var phi_42697_: i32;
var phi_42725_: type_23;
var phi_42774_: u32;
var phi_42775_: u32;
var phi_42776_: u32;
var phi_43323_: i32;
var phi_43334_: i32;
var phi_43362_: type_23;
var phi_43411_: u32;
var phi_43412_: u32;
var phi_43413_: u32;
var phi_43960_: i32;
var phi_43971_: i32;
var phi_43999_: type_23;
var phi_44048_: u32;
var phi_44049_: u32;
var phi_44050_: u32;
var phi_44615_: type_23;
var phi_44693_: i32;
var phi_44704_: i32;
var phi_44732_: type_23;
var phi_44781_: u32;
var phi_44782_: u32;
var phi_44783_: u32;
var phi_45330_: i32;
var phi_45341_: i32;
var phi_45369_: type_23;
var phi_45418_: u32;
var phi_45419_: u32;
var phi_45420_: u32;
var phi_45967_: i32;
var phi_45978_: i32;
var phi_46006_: type_23;
var phi_46055_: u32;
var phi_46056_: u32;
var phi_46057_: u32;
var phi_46604_: i32;
var phi_46615_: i32;
var phi_46643_: type_23;
var phi_46692_: u32;
var phi_46693_: u32;
var phi_46694_: u32;
var phi_47259_: type_23;
var phi_47337_: i32;
var phi_47348_: i32;
var phi_47376_: type_23;
var phi_47425_: u32;
var phi_47426_: u32;
var phi_47427_: u32;
var phi_47974_: i32;
var phi_47985_: i32;
var phi_48013_: type_23;
var phi_48062_: u32;
var phi_48063_: u32;
var phi_48064_: u32;
var phi_48611_: i32;
var phi_48622_: i32;
var phi_48650_: type_23;
var phi_48699_: u32;
var phi_48700_: u32;
var phi_48701_: u32;
var phi_49248_: i32;
var phi_49259_: i32;
var phi_49287_: type_23;
var phi_49336_: u32;
var phi_49337_: u32;
var phi_49338_: u32;
var phi_49894_: type_23;
var phi_50127_: u32;
var phi_50157_: u32;
var phi_50187_: u32;
var phi_41291_: i32;
var phi_41137_: i32;
var phi_50253_: type_23;
var phi_50328_: i32;
var phi_50332_: type_23;
var phi_50335_: i32;
var phi_50486_: type_23;
var phi_50489_: i32;
var phi_50619_: type_23;
var phi_50668_: u32;
var phi_50669_: u32;
var phi_50670_: u32;
var phi_50796_: i32;
var phi_50807_: i32;
var phi_51376_: type_23;
var phi_51573_: u32;
var phi_51574_: u32;
var phi_51575_: u32;
var phi_51609_: u32;
var phi_51639_: u32;
var phi_51669_: u32;
var phi_51706_: type_23;
var phi_50487_: type_23;
var phi_50490_: i32;
var phi_50333_: type_23;
var phi_50336_: i32;
var local_233: type_23;
var local_234: type_23;
var phi_51723_: i32;
var phi_51758_: i32;
var phi_51912_: i32;
var phi_52017_: type_23;
var phi_52569_: type_23;
var phi_52802_: u32;
var phi_52832_: u32;
var phi_52862_: u32;
var phi_51913_: i32;
var phi_51759_: i32;
var phi_52911_: i32;
var phi_53065_: i32;
var phi_53170_: type_23;
var phi_53748_: type_23;
var phi_53826_: i32;
var phi_53837_: i32;
var phi_53865_: type_23;
var phi_53914_: u32;
var phi_53915_: u32;
var phi_53916_: u32;
var phi_54463_: i32;
var phi_54474_: i32;
var phi_54502_: type_23;
var phi_54551_: u32;
var phi_54552_: u32;
var phi_54553_: u32;
var phi_55100_: i32;
var phi_55111_: i32;
var phi_55139_: type_23;
var phi_55188_: u32;
var phi_55189_: u32;
var phi_55190_: u32;
var phi_55737_: i32;
var phi_55748_: i32;
var phi_55776_: type_23;
var phi_55825_: u32;
var phi_55826_: u32;
var phi_55827_: u32;
var phi_56383_: type_23;
var phi_56616_: u32;
var phi_56646_: u32;
var phi_56676_: u32;
var phi_53066_: i32;
var phi_52912_: i32;
var phi_56721_: i32;
var phi_56875_: i32;
var phi_56980_: type_23;
var phi_57556_: type_23;
var phi_57634_: i32;
var phi_57645_: i32;
var phi_57673_: type_23;
var phi_57722_: u32;
var phi_57723_: u32;
var phi_57724_: u32;
var phi_58271_: i32;
var phi_58282_: i32;
var phi_58310_: type_23;
var phi_58359_: u32;
var phi_58360_: u32;
var phi_58361_: u32;
var phi_58908_: i32;
var phi_58919_: i32;
var phi_58947_: type_23;
var phi_58996_: u32;
var phi_58997_: u32;
var phi_58998_: u32;
var phi_59545_: i32;
var phi_59556_: i32;
var phi_59584_: type_23;
var phi_59633_: u32;
var phi_59634_: u32;
var phi_59635_: u32;
var phi_60200_: type_23;
var phi_60278_: i32;
var phi_60289_: i32;
var phi_60317_: type_23;
var phi_60366_: u32;
var phi_60367_: u32;
var phi_60368_: u32;
var phi_60915_: i32;
var phi_60926_: i32;
var phi_60954_: type_23;
var phi_61003_: u32;
var phi_61004_: u32;
var phi_61005_: u32;
var phi_61552_: i32;
var phi_61563_: i32;
var phi_61591_: type_23;
var phi_61640_: u32;
var phi_61641_: u32;
var phi_61642_: u32;
var phi_62189_: i32;
var phi_62200_: i32;
var phi_62228_: type_23;
var phi_62277_: u32;
var phi_62278_: u32;
var phi_62279_: u32;
var phi_62844_: type_23;
var phi_62922_: i32;
var phi_62933_: i32;
var phi_62961_: type_23;
var phi_63010_: u32;
var phi_63011_: u32;
var phi_63012_: u32;
var phi_63559_: i32;
var phi_63570_: i32;
var phi_63598_: type_23;
var phi_63647_: u32;
var phi_63648_: u32;
var phi_63649_: u32;
var phi_64196_: i32;
var phi_64207_: i32;
var phi_64235_: type_23;
var phi_64284_: u32;
var phi_64285_: u32;
var phi_64286_: u32;
var phi_64833_: i32;
var phi_64844_: i32;
var phi_64872_: type_23;
var phi_64921_: u32;
var phi_64922_: u32;
var phi_64923_: u32;
var phi_65479_: type_23;
var phi_65712_: u32;
var phi_65742_: u32;
var phi_65772_: u32;
var phi_56876_: i32;
var phi_56722_: i32;
var local_235: u32;
var local_236: u32;
var local_237: u32;
var local_238: u32;
var local_239: u32;
var local_240: u32;
var local_241: type_23;
var local_242: type_23;
let _e248 = global;
let _e258 = arrayLength((&global_5.member));
let _e261 = arrayLength((&global_6.member));
let _e264 = arrayLength((&global_2.member));
let _e267 = arrayLength((&global_7.member));
let _e269 = arrayLength((&global_8.member));
let _e272 = global_1.member.member;
if (_e248.x < _e272.member) {
if (_e248.y < _e272.member_1) {
let _e280 = bitcast<i32>(_e248.x);
let _e284 = global_1.member.member.member;
let _e285 = bitcast<i32>(_e284);
let _e289 = global_1.member.member_12.member_4;
let _e293 = global_1.member.member_12.member_6;
let _e295 = bitcast<i32>((_e289 * _e293));
let _e297 = bitcast<i32>((_e248.y * 16u));
local_225 = _e295;
local_226 = _e280;
local_227 = _e285;
let _e298 = local_225;
let _e299 = local_227;
let _e302 = local_226;
let _e303 = ((_e298 + (11i * _e299)) + _e302);
let _e305 = (bitcast<i32>(arrayLength((&global_4.member))) - 1i);
let _e307 = select(_e305, _e303, (_e303 < _e305));
let _e312 = global_4.member[bitcast<u32>(select(0i, _e307, (_e307 > 0i)))];
let _e313 = f32(_e297);
if (_e312 < _e313) {
phi_700_ = bool();
phi_701_ = true;
} else {
let _e315 = local_225;
let _e316 = local_227;
let _e319 = local_226;
let _e320 = ((_e315 + (10i * _e316)) + _e319);
let _e322 = select(_e305, _e320, (_e320 < _e305));
let _e327 = global_4.member[bitcast<u32>(select(0i, _e322, (_e322 > 0i)))];
let _e330 = (_e327 > f32((_e297 + 15i)));
if _e330 {
phi_699_ = bool();
} else {
let _e331 = local_225;
let _e332 = local_227;
let _e335 = local_226;
let _e336 = ((_e331 + (11i * _e332)) + _e335);
let _e338 = select(_e305, _e336, (_e336 < _e305));
let _e343 = global_4.member[bitcast<u32>(select(0i, _e338, (_e338 > 0i)))];
phi_699_ = (_e327 <= _e343);
}
let _e346 = phi_699_;
phi_700_ = _e346;
phi_701_ = _e330;
}
let _e348 = phi_700_;
let _e350 = phi_701_;
if select(_e348, false, _e350) {
local_222 = _e295;
local_223 = _e280;
local_224 = _e285;
let _e352 = local_222;
let _e353 = local_224;
let _e356 = local_223;
let _e357 = ((_e352 + (10i * _e353)) + _e356);
let _e359 = select(_e305, _e357, (_e357 < _e305));
let _e364 = global_4.member[bitcast<u32>(select(0i, _e359, (_e359 > 0i)))];
let _e365 = local_222;
let _e366 = local_224;
let _e369 = local_223;
let _e370 = ((_e365 + (11i * _e366)) + _e369);
let _e372 = select(_e305, _e370, (_e370 < _e305));
let _e377 = global_4.member[bitcast<u32>(select(0i, _e372, (_e372 > 0i)))];
let _e378 = local_222;
let _e379 = local_224;
let _e382 = local_223;
let _e383 = ((_e378 + (12i * _e379)) + _e382);
let _e385 = select(_e305, _e383, (_e383 < _e305));
let _e390 = global_4.member[bitcast<u32>(select(0i, _e385, (_e385 > 0i)))];
let _e391 = local_222;
let _e392 = local_224;
let _e395 = local_223;
let _e396 = ((_e391 + (13i * _e392)) + _e395);
let _e398 = select(_e305, _e396, (_e396 < _e305));
let _e403 = global_4.member[bitcast<u32>(select(0i, _e398, (_e398 > 0i)))];
local_219 = _e295;
local_220 = _e280;
local_221 = _e285;
let _e404 = local_219;
let _e405 = local_221;
let _e407 = local_220;
let _e408 = ((_e404 + _e405) + _e407);
let _e410 = select(_e305, _e408, (_e408 < _e305));
let _e415 = global_4.member[bitcast<u32>(select(0i, _e410, (_e410 > 0i)))];
let _e416 = local_219;
let _e417 = local_221;
let _e420 = local_220;
let _e421 = ((_e416 + (2i * _e417)) + _e420);
let _e423 = select(_e305, _e421, (_e421 < _e305));
let _e428 = global_4.member[bitcast<u32>(select(0i, _e423, (_e423 > 0i)))];
let _e429 = local_219;
let _e430 = local_221;
let _e433 = local_220;
let _e434 = ((_e429 + (3i * _e430)) + _e433);
let _e436 = select(_e305, _e434, (_e434 < _e305));
let _e441 = global_4.member[bitcast<u32>(select(0i, _e436, (_e436 > 0i)))];
let _e442 = local_219;
let _e443 = local_220;
let _e444 = (_e442 + _e443);
let _e446 = select(_e305, _e444, (_e444 < _e305));
let _e451 = global_4.member[bitcast<u32>(select(0i, _e446, (_e446 > 0i)))];
let _e452 = (_e451 > 0f);
let _e453 = local_219;
let _e454 = local_221;
let _e457 = local_220;
let _e458 = ((_e453 + (4i * _e454)) + _e457);
let _e460 = select(_e305, _e458, (_e458 < _e305));
let _e465 = global_4.member[bitcast<u32>(select(0i, _e460, (_e460 > 0i)))];
let _e466 = local_219;
let _e467 = local_221;
let _e470 = local_220;
let _e471 = ((_e466 + (5i * _e467)) + _e470);
let _e473 = select(_e305, _e471, (_e471 < _e305));
let _e478 = global_4.member[bitcast<u32>(select(0i, _e473, (_e473 > 0i)))];
let _e479 = local_219;
let _e480 = local_221;
let _e483 = local_220;
let _e484 = ((_e479 + (6i * _e480)) + _e483);
let _e486 = select(_e305, _e484, (_e484 < _e305));
let _e491 = global_4.member[bitcast<u32>(select(0i, _e486, (_e486 > 0i)))];
let _e492 = local_219;
let _e493 = local_221;
let _e496 = local_220;
let _e497 = ((_e492 + (7i * _e493)) + _e496);
let _e499 = select(_e305, _e497, (_e497 < _e305));
let _e504 = global_4.member[bitcast<u32>(select(0i, _e499, (_e499 > 0i)))];
let _e505 = local_219;
let _e506 = local_221;
let _e509 = local_220;
let _e510 = ((_e505 + (8i * _e506)) + _e509);
let _e512 = select(_e305, _e510, (_e510 < _e305));
let _e517 = global_4.member[bitcast<u32>(select(0i, _e512, (_e512 > 0i)))];
let _e518 = local_219;
let _e519 = local_221;
let _e522 = local_220;
let _e523 = ((_e518 + (9i * _e519)) + _e522);
let _e525 = select(_e305, _e523, (_e523 < _e305));
let _e530 = global_4.member[bitcast<u32>(select(0i, _e525, (_e525 > 0i)))];
let _e533 = bitcast<f32>((bitcast<u32>(_e428) & 2147483647u));
let _e537 = global_1.member.member_1.member;
let _e541 = global_1.member.member_1.member_1;
let _e542 = bitcast<i32>(_e537);
let _e543 = bitcast<i32>(_e541);
if _e452 {
phi_1081_ = type_23(_e543, _e542);
} else {
phi_1081_ = type_23(_e542, _e543);
}
let _e547 = phi_1081_;
let _e552 = global_1.member.member_12.member_9;
if ((_e452 != (_e552 == 1u)) || (_e297 >= _e547.member)) {
} else {
let _e560 = global_1.member.member_12.member_5;
local_216 = bitcast<i32>((_e289 * _e560));
local_217 = _e280;
local_218 = _e285;
let _e563 = local_216;
let _e564 = local_217;
let _e565 = (_e563 + _e564);
let _e567 = (bitcast<i32>(arrayLength((&global_3.member))) - 1i);
let _e569 = select(_e567, _e565, (_e565 < _e567));
let _e574 = global_3.member[bitcast<u32>(select(0i, _e569, (_e569 > 0i)))];
let _e575 = local_216;
let _e576 = local_218;
let _e578 = local_217;
let _e579 = ((_e575 + _e576) + _e578);
let _e581 = select(_e567, _e579, (_e579 < _e567));
let _e586 = global_3.member[bitcast<u32>(select(0i, _e581, (_e581 > 0i)))];
let _e587 = local_216;
let _e588 = local_218;
let _e591 = local_217;
let _e592 = ((_e587 + (2i * _e588)) + _e591);
let _e594 = select(_e567, _e592, (_e592 < _e567));
let _e599 = global_3.member[bitcast<u32>(select(0i, _e594, (_e594 > 0i)))];
let _e600 = local_216;
let _e601 = local_218;
let _e604 = local_217;
let _e605 = ((_e600 + (3i * _e601)) + _e604);
let _e607 = select(_e567, _e605, (_e605 < _e567));
let _e612 = global_3.member[bitcast<u32>(select(0i, _e607, (_e607 > 0i)))];
let _e613 = local_216;
let _e614 = local_218;
let _e617 = local_217;
let _e618 = ((_e613 + (4i * _e614)) + _e617);
let _e620 = select(_e567, _e618, (_e618 < _e567));
let _e625 = global_3.member[bitcast<u32>(select(0i, _e620, (_e620 > 0i)))];
let _e626 = local_216;
let _e627 = local_218;
let _e630 = local_217;
let _e631 = ((_e626 + (5i * _e627)) + _e630);
let _e633 = select(_e567, _e631, (_e631 < _e567));
let _e638 = global_3.member[bitcast<u32>(select(0i, _e633, (_e633 > 0i)))];
let _e639 = local_216;
let _e640 = local_218;
let _e643 = local_217;
let _e644 = ((_e639 + (18i * _e640)) + _e643);
let _e646 = select(_e567, _e644, (_e644 < _e567));
let _e651 = global_3.member[bitcast<u32>(select(0i, _e646, (_e646 > 0i)))];
let _e652 = local_216;
let _e653 = local_218;
let _e656 = local_217;
let _e657 = ((_e652 + (19i * _e653)) + _e656);
let _e659 = select(_e567, _e657, (_e657 < _e567));
let _e664 = global_3.member[bitcast<u32>(select(0i, _e659, (_e659 > 0i)))];
let _e665 = local_216;
let _e666 = local_218;
let _e669 = local_217;
let _e670 = ((_e665 + (20i * _e666)) + _e669);
let _e672 = select(_e567, _e670, (_e670 < _e567));
let _e677 = global_3.member[bitcast<u32>(select(0i, _e672, (_e672 > 0i)))];
let _e678 = local_216;
let _e679 = local_218;
let _e682 = local_217;
let _e683 = ((_e678 + (23i * _e679)) + _e682);
let _e685 = select(_e567, _e683, (_e683 < _e567));
let _e690 = global_3.member[bitcast<u32>(select(0i, _e685, (_e685 > 0i)))];
let _e691 = (_e297 + 16i);
let _e693 = (0.5f * (16f - 1f));
let _e694 = (_e313 + _e693);
let _e698 = (-(((_e415 * _e694) + _e441)) / _e428);
let _e716 = (0.5f * 1f);
let _e718 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e465 * _e694) + ((_e478 * _e698) + _e491))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e504 * _e694) + ((_e517 * _e698) + _e530))) & 2147483647u)))) / _e533) + _e716));
let _e722 = global_1.member.member_18.member_1;
phi_1793_ = 8f;
phi_1796_ = 0u;
loop {
let _e724 = phi_1793_;
let _e726 = phi_1796_;
local_228 = _e726;
local_235 = _e726;
let _e729 = ((_e726 < _e722) && (_e718 >= _e724));
if _e729 {
phi_1794_ = (_e724 * 2f);
phi_1797_ = (_e726 + 1u);
} else {
phi_1794_ = f32();
phi_1797_ = u32();
}
let _e733 = phi_1794_;
let _e735 = phi_1797_;
continue;
continuing {
phi_1793_ = _e733;
phi_1796_ = _e735;
break if !(_e729);
}
}
let _e738 = local_228;
let _e742 = f32((1i << bitcast<u32>((_e738 & 31u))));
let _e745 = f32(_e691);
if (((_e313 - _e742) > _e390) && ((_e745 + _e742) < _e403)) {
let _e24984 = local_235;
phi_1841_ = _e24984;
} else {
phi_1826_ = 8f;
phi_1829_ = 0u;
loop {
let _e751 = phi_1826_;
let _e753 = phi_1829_;
local_236 = _e753;
let _e756 = ((_e753 < _e722) && ((_e718 * 0.125f) >= _e751));
if _e756 {
phi_1827_ = (_e751 * 2f);
phi_1830_ = (_e753 + 1u);
} else {
phi_1827_ = f32();
phi_1830_ = u32();
}
let _e760 = phi_1827_;
let _e762 = phi_1830_;
continue;
continuing {
phi_1826_ = _e760;
phi_1829_ = _e762;
break if !(_e756);
}
}
let _e24986 = local_236;
phi_1841_ = _e24986;
}
let _e765 = phi_1841_;
let _e766 = (_e297 - 16i);
let _e770 = (_e364 <= _e377);
let _e771 = f32(_e766);
if (((_e766 >= 0i) && (_e766 < _e547.member)) && ((_e770 && (_e377 >= _e771)) && (_e364 <= f32((_e297 - 1i))))) {
let _e779 = (_e771 + _e693);
let _e783 = (-(((_e415 * _e779) + _e441)) / _e428);
let _e802 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e465 * _e779) + ((_e478 * _e783) + _e491))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e504 * _e779) + ((_e517 * _e783) + _e530))) & 2147483647u)))) / _e533) + _e716));
phi_1896_ = 8f;
phi_1899_ = 0u;
loop {
let _e804 = phi_1896_;
let _e806 = phi_1899_;
local_229 = _e806;
local_237 = _e806;
let _e809 = ((_e806 < _e722) && (_e802 >= _e804));
if _e809 {
phi_1897_ = (_e804 * 2f);
phi_1900_ = (_e806 + 1u);
} else {
phi_1897_ = f32();
phi_1900_ = u32();
}
let _e813 = phi_1897_;
let _e815 = phi_1900_;
continue;
continuing {
phi_1896_ = _e813;
phi_1899_ = _e815;
break if !(_e809);
}
}
let _e818 = local_229;
let _e822 = f32((1i << bitcast<u32>((_e818 & 31u))));
if (((_e771 - _e822) > _e390) && ((_e313 + _e822) < _e403)) {
let _e24998 = local_237;
phi_1944_ = _e24998;
} else {
phi_1929_ = 8f;
phi_1932_ = 0u;
loop {
let _e830 = phi_1929_;
let _e832 = phi_1932_;
local_238 = _e832;
let _e835 = ((_e832 < _e722) && ((_e802 * 0.125f) >= _e830));
if _e835 {
phi_1930_ = (_e830 * 2f);
phi_1933_ = (_e832 + 1u);
} else {
phi_1930_ = f32();
phi_1933_ = u32();
}
let _e839 = phi_1930_;
let _e841 = phi_1933_;
continue;
continuing {
phi_1929_ = _e839;
phi_1932_ = _e841;
break if !(_e835);
}
}
let _e25000 = local_238;
phi_1944_ = _e25000;
}
let _e844 = phi_1944_;
phi_1945_ = _e844;
} else {
phi_1945_ = _e765;
}
let _e846 = phi_1945_;
if (((_e691 >= 0i) && (_e691 < _e547.member)) && ((_e770 && (_e377 >= _e745)) && (_e364 <= f32((_e297 + 31i))))) {
let _e858 = (_e745 + _e693);
let _e862 = (-(((_e415 * _e858) + _e441)) / _e428);
let _e881 = (2f * (((0.5f * (bitcast<f32>((bitcast<u32>(((_e465 * _e858) + ((_e478 * _e862) + _e491))) & 2147483647u)) + bitcast<f32>((bitcast<u32>(((_e504 * _e858) + ((_e517 * _e862) + _e530))) & 2147483647u)))) / _e533) + _e716));
phi_2000_ = 8f;
phi_2003_ = 0u;
loop {
let _e883 = phi_2000_;
let _e885 = phi_2003_;
local_230 = _e885;
local_239 = _e885;
let _e888 = ((_e885 < _e722) && (_e881 >= _e883));
if _e888 {
phi_2001_ = (_e883 * 2f);
phi_2004_ = (_e885 + 1u);
} else {
phi_2001_ = f32();
phi_2004_ = u32();
}
let _e892 = phi_2001_;
let _e894 = phi_2004_;
continue;
continuing {
phi_2000_ = _e892;
phi_2003_ = _e894;
break if !(_e888);
}
}
let _e897 = local_230;
let _e901 = f32((1i << bitcast<u32>((_e897 & 31u))));
if (((_e745 - _e901) > _e390) && ((f32((_e297 + 32i)) + _e901) < _e403)) {
let _e25013 = local_239;
phi_2048_ = _e25013;
} else {
phi_2033_ = 8f;
phi_2036_ = 0u;
loop {
let _e910 = phi_2033_;
let _e912 = phi_2036_;
local_240 = _e912;
let _e915 = ((_e912 < _e722) && ((_e881 * 0.125f) >= _e910));
if _e915 {
phi_2034_ = (_e910 * 2f);
phi_2037_ = (_e912 + 1u);
} else {
phi_2034_ = f32();
phi_2037_ = u32();
}
let _e919 = phi_2034_;
let _e921 = phi_2037_;
continue;
continuing {
phi_2033_ = _e919;
phi_2036_ = _e921;
break if !(_e915);
}
}
let _e25015 = local_240;
phi_2048_ = _e25015;
}
let _e924 = phi_2048_;
phi_2049_ = _e924;
} else {
phi_2049_ = _e765;
}
let _e926 = phi_2049_;
if (_e272.member_2 == 1u) {
let _e930 = global_1.member.member_1.member;
let _e933 = global_1.member.member_1.member_1;
let _e934 = bitcast<i32>(_e930);
let _e935 = bitcast<i32>(_e933);
if _e452 {
phi_2095_ = type_23(_e935, _e934);
} else {
phi_2095_ = type_23(_e934, _e935);
}
let _e939 = phi_2095_;
let _e943 = f32((_e297 + 15i));
let _e945 = select(_e943, _e377, (_e377 < _e943));
let _e947 = select(_e313, _e945, (_e945 > _e313));
let _e949 = select(_e943, _e947, (_e947 < _e943));
let _e956 = select(0i, select(select(i32(_e949), i32(-2147483648), (_e949 < -2147483600f)), 2147483647i, (_e949 > 2147483500f)), (_e949 == _e949));
let _e960 = (_e956 - select(0i, 1i, (_e949 < f32(_e956))));
let _e961 = bitcast<i32>(_e960);
let _e963 = select(_e313, _e364, (_e364 > _e313));
let _e965 = select(_e313, _e963, (_e963 > _e313));
let _e967 = select(_e943, _e965, (_e965 < _e943));
let _e974 = select(0i, select(select(i32(_e967), i32(-2147483648), (_e967 < -2147483600f)), 2147483647i, (_e967 > 2147483500f)), (_e967 == _e967));
let _e978 = (_e974 - select(0i, 1i, (_e967 < f32(_e974))));
let _e979 = bitcast<i32>(_e978);
if (_e961 < _e939.member) {
phi_2170_ = _e961;
} else {
phi_2170_ = (_e939.member - 1i);
}
let _e983 = phi_2170_;
let _e984 = (_e939.member_1 - 1i);
let _e985 = (_e765 == 0u);
if _e985 {
let _e987 = select(_e846, 0u, (_e846 == _e765));
let _e991 = select(_e926, 0u, ((_e926 == _e765) || (_e926 == _e846)));
let _e999 = ((select(0u, 1u, (_e765 > 0u)) + select(0u, 1u, (_e987 > 0u))) + select(0u, 1u, (_e991 > 0u)));
if (_e999 == 0u) {
phi_2208_ = 0i;
loop {
let _e1002 = phi_2208_;
let _e1003 = (_e1002 < 16i);
if _e1003 {
let _e1005 = (_e979 + (_e1002 & 15i));
let _e1009 = (((f32(_e1005) + 0.5f) * 1f) - 0.5f);
let _e1013 = (-(((_e415 * _e1009) + _e441)) / _e428);
let _e1020 = bitcast<f32>((bitcast<u32>(((_e465 * _e1009) + ((_e478 * _e1013) + _e491))) & 2147483647u));
let _e1027 = bitcast<f32>((bitcast<u32>(((_e504 * _e1009) + ((_e517 * _e1013) + _e530))) & 2147483647u));
let _e1031 = (((0.5f * (_e1020 + _e1027)) / _e533) + _e716);
let _e1032 = (1f / 1f);
let _e1040 = ((((_e1013 + _e1031) + 0.5f) * _e1032) - 0.5f);
let _e1041 = f32(_e984);
let _e1042 = (0f - 1f);
let _e1044 = select(_e1042, _e1040, (_e1040 > _e1042));
let _e1046 = select(_e1041, _e1044, (_e1044 < _e1041));
let _e1053 = select(0i, select(select(i32(_e1046), i32(-2147483648), (_e1046 < -2147483600f)), 2147483647i, (_e1046 > 2147483500f)), (_e1046 == _e1046));
let _e1058 = (((((_e1013 - _e1031) + 0.5f) * _e1032) - 0.5f) + 1f);
let _e1059 = (_e1041 + 1f);
let _e1061 = select(0f, _e1058, (_e1058 > 0f));
let _e1063 = select(_e1059, _e1061, (_e1061 < _e1059));
let _e1070 = select(0i, select(select(i32(_e1063), i32(-2147483648), (_e1063 < -2147483600f)), 2147483647i, (_e1063 > 2147483500f)), (_e1063 == _e1063));
let _e1081 = ((1e-4f * 1f) * _e533);
let _e1083 = select(_e1027, _e1020, (_e1020 > _e1027));
let _e1085 = select(_e1081, _e1083, (_e1083 > _e1081));
let _e1087 = select(_e1027, _e1020, (_e1020 < _e1027));
let _e1089 = select(_e1081, _e1087, (_e1087 > _e1081));
let _e1091 = (0.5f * (_e1085 + _e1089));
let _e1092 = (0.5f / _e1089);
let _e1093 = (1f / _e1085);
phi_2362_ = 0i;
loop {
let _e1095 = phi_2362_;
let _e1097 = (((_e1070 - select(0i, 1i, (_e1063 < f32(_e1070)))) + (_e1002 >> bitcast<u32>(4u))) + bitcast<i32>(_e1095));
let _e1098 = (_e1097 <= select(-1i, (_e1053 - select(0i, 1i, (_e1046 < f32(_e1053)))), (_e1005 <= _e983)));
if _e1098 {
let _e1104 = (((((f32(_e1097) + 0.5f) * 1f) - 0.5f) - _e1013) * _e533);
let _e1105 = (_e533 * 1f);
let _e1107 = (0.5f * _e1105);
let _e1108 = (_e1104 + _e1107);
let _e1109 = -(_e1108);
let _e1112 = (_e1091 - select(_e1109, _e1108, (_e1108 > _e1109)));
let _e1114 = select(0f, _e1112, (_e1112 > 0f));
let _e1116 = select(_e1089, _e1114, (_e1114 < _e1089));
let _e1119 = (_e1112 - _e1089);
let _e1123 = (((_e1116 * (_e1116 * _e1092)) + select(0f, _e1119, (_e1119 > 0f))) * _e1093);
let _e1127 = (_e1104 - _e1107);
let _e1128 = -(_e1127);
let _e1131 = (_e1091 - select(_e1128, _e1127, (_e1127 > _e1128)));
let _e1133 = select(0f, _e1131, (_e1131 > 0f));
let _e1135 = select(_e1089, _e1133, (_e1133 < _e1089));
let _e1138 = (_e1131 - _e1089);
let _e1142 = (((_e1135 * (_e1135 * _e1092)) + select(0f, _e1138, (_e1138 > 0f))) * _e1093);
if _e452 {
phi_2467_ = type_23(_e1097, _e1005);
} else {
phi_2467_ = type_23(_e1005, _e1097);
}
let _e1151 = phi_2467_;
let _e1155 = bitcast<i32>((_e930 * _e933));
local_214 = _e1155;
local_215 = ((_e1151.member_1 * _e934) + _e1151.member);
let _e1158 = local_214;
let _e1159 = local_215;
let _e1160 = (_e1158 + _e1159);
let _e1162 = (bitcast<i32>(_e258) - 1i);
let _e1164 = select(_e1162, _e1160, (_e1160 < _e1162));
let _e1169 = global_5.member[bitcast<u32>(select(0i, _e1164, (_e1164 > 0i)))];
let _e1170 = local_214;
let _e1172 = local_215;
let _e1173 = ((2i * _e1170) + _e1172);
let _e1175 = select(_e1162, _e1173, (_e1173 < _e1162));
let _e1180 = global_5.member[bitcast<u32>(select(0i, _e1175, (_e1175 > 0i)))];
let _e1181 = local_215;
let _e1183 = select(_e1162, _e1181, (_e1181 < _e1162));
let _e1188 = global_5.member[bitcast<u32>(select(0i, _e1183, (_e1183 > 0i)))];
let _e1189 = local_215;
let _e1200 = global_1.member.member_2.member;
let _e1201 = (((((f32(_e1151.member) + 0.5f) / f32(_e934)) * 2f) - 1f) * _e1200);
let _e1208 = global_1.member.member_2.member_1;
let _e1209 = ((1f - (((f32(_e1151.member_1) + 0.5f) / f32(_e935)) * 2f)) * _e1208);
let _e1211 = global_1.member.member_3;
let _e1219 = global_1.member.member_4;
let _e1226 = ((_e1211.member * _e1201) + (_e1219.member * _e1209));
let _e1227 = ((_e1211.member_1 * _e1201) + (_e1219.member_1 * _e1209));
let _e1228 = ((_e1211.member_2 * _e1201) + (_e1219.member_2 * _e1209));
let _e1231 = global_1.member.member_2.member_3;
let _e1232 = (_e1231 != 0u);
let _e1234 = global_1.member.member_5;
let _e1241 = select((_e1234.member + _e1226), _e1234.member, _e1232);
let _e1242 = select((_e1234.member_1 + _e1227), _e1234.member_1, _e1232);
let _e1243 = select((_e1234.member_2 + _e1228), _e1234.member_2, _e1232);
let _e1245 = global_1.member.member_6;
let _e1252 = select(_e1245.member, (_e1245.member + _e1226), _e1232);
let _e1253 = select(_e1245.member_1, (_e1245.member_1 + _e1227), _e1232);
let _e1254 = select(_e1245.member_2, (_e1245.member_2 + _e1228), _e1232);
let _e1259 = (((_e1241 * _e1241) + (_e1242 * _e1242)) + (_e1243 * _e1243));
let _e1262 = sqrt(select(0f, _e1259, (_e1259 > 0f)));
let _e1263 = (1f / _e1262);
let _e1264 = (_e1241 * _e1263);
let _e1265 = (_e1242 * _e1263);
let _e1266 = (_e1243 * _e1263);
let _e1267 = (_e574 - _e1252);
let _e1268 = (_e586 - _e1253);
let _e1269 = (_e599 - _e1254);
let _e1274 = (((_e1267 * _e1264) + (_e1268 * _e1265)) + (_e1269 * _e1266));
let _e1279 = (((_e1267 * _e612) + (_e1268 * _e625)) + (_e1269 * _e638));
let _e1284 = (((_e1264 * _e612) + (_e1265 * _e625)) + (_e1266 * _e638));
let _e1287 = ((_e1265 * _e638) - (_e1266 * _e625));
let _e1290 = ((_e1266 * _e612) - (_e1264 * _e638));
let _e1293 = ((_e1264 * _e625) - (_e1265 * _e612));
let _e1298 = (((_e1287 * _e1287) + (_e1290 * _e1290)) + (_e1293 * _e1293));
let _e1301 = (1f / select(1e-9f, _e1298, (_e1298 > 1e-9f)));
let _e1304 = ((_e1274 - (_e1284 * _e1279)) * _e1301);
let _e1307 = (((_e1284 * _e1274) - _e1279) * _e1301);
let _e1313 = -(_e1284);
let _e1316 = global_1.member.member_13.member_2;
let _e1317 = (_e1316 * _e1316);
let _e1321 = ((1f + _e1317) - ((2f * _e1316) * _e1313));
let _e1323 = select(1e-9f, _e1321, (_e1321 > 1e-9f));
let _e1335 = global_1.member.member_13.member_3;
let _e1343 = global_1.member.member_12.member_10;
let _e1346 = global_1.member.member_12.member_4;
let _e1349 = global_1.member.member_12.member_11;
let _e1355 = global_1.member.member.member;
let _e1357 = (_e1307 / _e690);
local_211 = bitcast<i32>((_e1343 + (_e1346 * _e1349)));
local_212 = _e280;
local_213 = bitcast<i32>(_e1355);
let _e1360 = global_1.member.member_13.member_6;
let _e1361 = f32(_e1360);
let _e1363 = select(0f, _e1357, (_e1357 > 0f));
let _e1366 = (select(1f, _e1363, (_e1363 < 1f)) * _e1361);
let _e1367 = (_e1361 - 1f);
let _e1369 = select(0f, _e1367, (_e1367 > 0f));
let _e1371 = select(0f, _e1366, (_e1366 > 0f));
let _e1373 = select(_e1369, _e1371, (_e1371 < _e1369));
let _e1380 = select(0i, select(select(i32(_e1373), i32(-2147483648), (_e1373 < -2147483600f)), 2147483647i, (_e1373 > 2147483500f)), (_e1373 == _e1373));
let _e1384 = (_e1380 - select(0i, 1i, (_e1373 < f32(_e1380))));
if (_e1384 > 0i) {
let _e1387 = local_211;
let _e1388 = local_213;
let _e1391 = local_212;
let _e1392 = ((_e1387 + ((_e1384 - 1i) * _e1388)) + _e1391);
let _e1394 = (bitcast<i32>(_e267) - 1i);
let _e1396 = select(_e1394, _e1392, (_e1392 < _e1394));
let _e1401 = global_7.member[bitcast<u32>(select(0i, _e1396, (_e1396 > 0i)))];
phi_2880_ = _e1401;
} else {
phi_2880_ = 0f;
}
let _e1403 = phi_2880_;
let _e1404 = local_211;
let _e1405 = local_213;
let _e1408 = local_212;
let _e1409 = ((_e1404 + (_e1384 * _e1405)) + _e1408);
let _e1411 = (bitcast<i32>(_e267) - 1i);
let _e1413 = select(_e1411, _e1409, (_e1409 < _e1411));
let _e1418 = global_7.member[bitcast<u32>(select(0i, _e1413, (_e1413 > 0i)))];
let _e1425 = (_e1180 - _e1169);
let _e1428 = ((_e1304 - _e1169) / select(1e-9f, _e1425, (_e1425 > 1e-9f)));
local_208 = 0i;
local_209 = _e1189;
local_210 = _e1155;
let _e1430 = select(0f, _e1428, (_e1428 > 0f));
let _e1433 = (select(1f, _e1430, (_e1430 < 1f)) * _e1361);
let _e1435 = select(0f, _e1433, (_e1433 > 0f));
let _e1437 = select(_e1369, _e1435, (_e1435 < _e1369));
let _e1444 = select(0i, select(select(i32(_e1437), i32(-2147483648), (_e1437 < -2147483600f)), 2147483647i, (_e1437 > 2147483500f)), (_e1437 == _e1437));
let _e1448 = (_e1444 - select(0i, 1i, (_e1437 < f32(_e1444))));
if (_e1448 > 0i) {
let _e1451 = local_208;
let _e1452 = local_210;
let _e1455 = local_209;
let _e1456 = ((_e1451 + ((_e1448 - 1i) * _e1452)) + _e1455);
let _e1458 = select(_e1411, _e1456, (_e1456 < _e1411));
let _e1463 = global_7.member[bitcast<u32>(select(0i, _e1458, (_e1458 > 0i)))];
phi_3007_ = _e1463;
} else {
phi_3007_ = 0f;
}
let _e1465 = phi_3007_;
let _e1466 = local_208;
let _e1467 = local_210;
let _e1470 = local_209;
let _e1471 = ((_e1466 + (_e1448 * _e1467)) + _e1470);
let _e1473 = select(_e1411, _e1471, (_e1471 < _e1411));
let _e1478 = global_7.member[bitcast<u32>(select(0i, _e1473, (_e1473 > 0i)))];
let _e1484 = ((_e1403 + ((_e1418 - _e1403) * (_e1366 - f32(_e1384)))) + (_e1465 + ((_e1478 - _e1465) * (_e1433 - f32(_e1448)))));
let _e1493 = global_1.member.member_13.member_7;
let _e1494 = bitcast<i32>(_e1493);
let _e1497 = global_1.member.member_13.member_8;
let _e1498 = bitcast<i32>(_e1497);
let _e1501 = global_1.member.member_13.member_9;
let _e1502 = bitcast<i32>(_e1501);
let _e1505 = global_1.member.member_13.member_4;
let _e1511 = global_1.member.member_13.member_5;
let _e1515 = f32(_e1494);
let _e1520 = (((((_e1252 + (_e1264 * _e1304)) - _e1505.member) / (_e1511.member - _e1505.member)) * _e1515) - 0.5f);
let _e1521 = (_e1515 - 1f);
let _e1523 = select(0f, _e1520, (_e1520 > 0f));
let _e1525 = select(_e1521, _e1523, (_e1523 < _e1521));
let _e1526 = f32(_e1498);
let _e1531 = (((((_e1253 + (_e1265 * _e1304)) - _e1505.member_1) / (_e1511.member_1 - _e1505.member_1)) * _e1526) - 0.5f);
let _e1532 = (_e1526 - 1f);
let _e1534 = select(0f, _e1531, (_e1531 > 0f));
let _e1536 = select(_e1532, _e1534, (_e1534 < _e1532));
let _e1537 = f32(_e1502);
let _e1542 = (((((_e1254 + (_e1266 * _e1304)) - _e1505.member_2) / (_e1511.member_2 - _e1505.member_2)) * _e1537) - 0.5f);
let _e1543 = (_e1537 - 1f);
let _e1545 = select(0f, _e1542, (_e1542 > 0f));
let _e1547 = select(_e1543, _e1545, (_e1545 < _e1543));
let _e1549 = select(0f, _e1525, (_e1525 > 0f));
let _e1551 = select(1e6f, _e1549, (_e1549 < 1e6f));
let _e1558 = select(0i, select(select(i32(_e1551), i32(-2147483648), (_e1551 < -2147483600f)), 2147483647i, (_e1551 > 2147483500f)), (_e1551 == _e1551));
let _e1562 = (_e1558 - select(0i, 1i, (_e1551 < f32(_e1558))));
let _e1564 = select(0f, _e1536, (_e1536 > 0f));
let _e1566 = select(1e6f, _e1564, (_e1564 < 1e6f));
let _e1573 = select(0i, select(select(i32(_e1566), i32(-2147483648), (_e1566 < -2147483600f)), 2147483647i, (_e1566 > 2147483500f)), (_e1566 == _e1566));
let _e1577 = (_e1573 - select(0i, 1i, (_e1566 < f32(_e1573))));
let _e1579 = select(0f, _e1547, (_e1547 > 0f));
let _e1581 = select(1e6f, _e1579, (_e1579 < 1e6f));
let _e1588 = select(0i, select(select(i32(_e1581), i32(-2147483648), (_e1581 < -2147483600f)), 2147483647i, (_e1581 > 2147483500f)), (_e1581 == _e1581));
let _e1592 = (_e1588 - select(0i, 1i, (_e1581 < f32(_e1588))));
let _e1596 = (_e1536 - f32(_e1577));
let _e1598 = (_e1547 - f32(_e1592));
local_206 = (_e1525 - f32(_e1562));
let _e1599 = (_e1562 + 1i);
let _e1601 = select(_e1599, 0i, (_e1599 < 0i));
if (_e1601 >= _e1494) {
phi_3155_ = (_e1494 - 1i);
} else {
phi_3155_ = _e1601;
}
let _e1605 = phi_3155_;
local_207 = (_e1605 - _e1562);
let _e1607 = (_e1577 + 1i);
let _e1609 = select(_e1607, 0i, (_e1607 < 0i));
if (_e1609 >= _e1498) {
phi_3168_ = (_e1498 - 1i);
} else {
phi_3168_ = _e1609;
}
let _e1613 = phi_3168_;
let _e1615 = ((_e1613 - _e1577) * _e1494);
let _e1616 = (_e1592 + 1i);
let _e1618 = select(_e1616, 0i, (_e1616 < 0i));
if (_e1618 >= _e1502) {
phi_3182_ = (_e1502 - 1i);
} else {
phi_3182_ = _e1618;
}
let _e1622 = phi_3182_;
let _e1628 = global_1.member.member_13.member_10;
let _e1634 = ((bitcast<i32>(_e1628) + (((_e1592 * _e1498) + _e1577) * _e1494)) + _e1562);
let _e1636 = (bitcast<i32>(_e264) - 1i);
let _e1638 = select(_e1636, _e1634, (_e1634 < _e1636));
let _e1643 = global_2.member[bitcast<u32>(select(0i, _e1638, (_e1638 > 0i)))];
let _e1644 = local_206;
let _e1647 = local_207;
let _e1648 = (_e1634 + _e1647);
let _e1650 = select(_e1636, _e1648, (_e1648 < _e1636));
let _e1655 = global_2.member[bitcast<u32>(select(0i, _e1650, (_e1650 > 0i)))];
let _e1656 = local_206;
let _e1659 = (1f - _e1596);
let _e1661 = (_e1634 + _e1615);
let _e1663 = select(_e1636, _e1661, (_e1661 < _e1636));
let _e1668 = global_2.member[bitcast<u32>(select(0i, _e1663, (_e1663 > 0i)))];
let _e1669 = local_206;
let _e1672 = local_207;
let _e1673 = (_e1661 + _e1672);
let _e1675 = select(_e1636, _e1673, (_e1673 < _e1636));
let _e1680 = global_2.member[bitcast<u32>(select(0i, _e1675, (_e1675 > 0i)))];
let _e1681 = local_206;
let _e1686 = (_e1634 + (((_e1622 - _e1592) * _e1494) * _e1498));
let _e1688 = select(_e1636, _e1686, (_e1686 < _e1636));
let _e1693 = global_2.member[bitcast<u32>(select(0i, _e1688, (_e1688 > 0i)))];
let _e1694 = local_206;
let _e1697 = local_207;
let _e1698 = (_e1686 + _e1697);
let _e1700 = select(_e1636, _e1698, (_e1698 < _e1636));
let _e1705 = global_2.member[bitcast<u32>(select(0i, _e1700, (_e1700 > 0i)))];
let _e1706 = local_206;
let _e1710 = (_e1686 + _e1615);
let _e1712 = select(_e1636, _e1710, (_e1710 < _e1636));
let _e1717 = global_2.member[bitcast<u32>(select(0i, _e1712, (_e1712 > 0i)))];
let _e1718 = local_206;
let _e1721 = local_207;
let _e1722 = (_e1710 + _e1721);
let _e1724 = select(_e1636, _e1722, (_e1722 < _e1636));
let _e1729 = global_2.member[bitcast<u32>(select(0i, _e1724, (_e1724 > 0i)))];
let _e1730 = local_206;
let _e1739 = ((_e1262 * (select(((1f - _e1317) / (_e1323 * sqrt(select(0f, _e1323, (_e1323 > 0f))))), (0.75f * (1f + (_e1313 * _e1313))), (_e1335 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e1643 * (1f - _e1644)) + (_e1655 * _e1656)) * _e1659) + (((_e1668 * (1f - _e1669)) + (_e1680 * _e1681)) * _e1596)) * (1f - _e1598)) + (((((_e1693 * (1f - _e1694)) + (_e1705 * _e1706)) * _e1659) + (((_e1717 * (1f - _e1718)) + (_e1729 * _e1730)) * _e1596)) * _e1598)));
let _e1742 = global_1.member.member_13.member_1;
let _e1751 = global_1.member.member_13.member;
let _e1756 = -((_e1751.member * _e1484));
let _e1758 = select(-87f, _e1756, (_e1756 > -87f));
let _e1760 = select(88f, _e1758, (_e1758 < 88f));
let _e1762 = ((_e1760 * 1.442695f) + 0.5f);
let _e1764 = select(-127f, _e1762, (_e1762 > -127f));
let _e1766 = select(128f, _e1764, (_e1764 < 128f));
let _e1773 = select(0i, select(select(i32(_e1766), i32(-2147483648), (_e1766 < -2147483600f)), 2147483647i, (_e1766 > 2147483500f)), (_e1766 == _e1766));
let _e1777 = (_e1773 - select(0i, 1i, (_e1766 < f32(_e1773))));
let _e1778 = f32(_e1777);
let _e1782 = ((_e1760 - (_e1778 * 0.6933594f)) - (_e1778 * -2.1219444e-4f));
let _e1804 = -((_e1751.member_1 * _e1484));
let _e1806 = select(-87f, _e1804, (_e1804 > -87f));
let _e1808 = select(88f, _e1806, (_e1806 < 88f));
let _e1810 = ((_e1808 * 1.442695f) + 0.5f);
let _e1812 = select(-127f, _e1810, (_e1810 > -127f));
let _e1814 = select(128f, _e1812, (_e1812 < 128f));
let _e1821 = select(0i, select(select(i32(_e1814), i32(-2147483648), (_e1814 < -2147483600f)), 2147483647i, (_e1814 > 2147483500f)), (_e1814 == _e1814));
let _e1825 = (_e1821 - select(0i, 1i, (_e1814 < f32(_e1821))));
let _e1826 = f32(_e1825);
let _e1830 = ((_e1808 - (_e1826 * 0.6933594f)) - (_e1826 * -2.1219444e-4f));
let _e1852 = -((_e1751.member_2 * _e1484));
let _e1854 = select(-87f, _e1852, (_e1852 > -87f));
let _e1856 = select(88f, _e1854, (_e1854 < 88f));
let _e1858 = ((_e1856 * 1.442695f) + 0.5f);
let _e1860 = select(-127f, _e1858, (_e1858 > -127f));
let _e1862 = select(128f, _e1860, (_e1860 < 128f));
let _e1869 = select(0i, select(select(i32(_e1862), i32(-2147483648), (_e1862 < -2147483600f)), 2147483647i, (_e1862 > 2147483500f)), (_e1862 == _e1862));
let _e1873 = (_e1869 - select(0i, 1i, (_e1862 < f32(_e1869))));
let _e1874 = f32(_e1873);
let _e1878 = ((_e1856 - (_e1874 * 0.6933594f)) - (_e1874 * -2.1219444e-4f));
let _e1905 = select(0f, _e1304, (((_e1307 >= 0f) && (_e1307 < _e690)) && (_e1304 > 0f)));
if _e452 {
phi_3617_ = type_23(_e1097, _e1005);
} else {
phi_3617_ = type_23(_e1005, _e1097);
}
let _e1916 = phi_3617_;
let _e1919 = (_e1098 && (((_e1905 > 0f) && (_e1905 < _e1188)) && true));
let _e1922 = global_1.member.member_18.member;
let _e1923 = (((select(_e1123, (1f - _e1123), (_e1108 >= 0f)) - select(_e1142, (1f - _e1142), (_e1127 >= 0f))) * (1f / _e1105)) * _e1922);
let _e1927 = select(0f, (((((_e651 * _e1742.member) * ((1f + (_e1782 * (1f + (_e1782 * (0.5f + (_e1782 * (0.16666667f + (_e1782 * (0.041666668f + (_e1782 * (0.008333334f + (_e1782 * (0.001388889f + (_e1782 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1777 + 127i)) << bitcast<u32>(23i))))) * _e1739) * 1f) * _e1923), _e1919);
let _e1928 = select(0f, (((((_e664 * _e1742.member_1) * ((1f + (_e1830 * (1f + (_e1830 * (0.5f + (_e1830 * (0.16666667f + (_e1830 * (0.041666668f + (_e1830 * (0.008333334f + (_e1830 * (0.001388889f + (_e1830 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1825 + 127i)) << bitcast<u32>(23i))))) * _e1739) * 1f) * _e1923), _e1919);
let _e1929 = select(0f, (((((_e677 * _e1742.member_2) * ((1f + (_e1878 * (1f + (_e1878 * (0.5f + (_e1878 * (0.16666667f + (_e1878 * (0.041666668f + (_e1878 * (0.008333334f + (_e1878 * (0.001388889f + (_e1878 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e1873 + 127i)) << bitcast<u32>(23i))))) * _e1739) * 1f) * _e1923), _e1919);
let _e1933 = (bitcast<f32>((bitcast<u32>(_e1927) & 2147483647u)) >= 1073741800f);
let _e1934 = (1f / 1048576f);
let _e1937 = ((_e1927 * select(1f, _e1934, _e1933)) + 0.5f);
let _e1939 = select(-1073741800f, _e1937, (_e1937 > -1073741800f));
let _e1941 = select(1073741800f, _e1939, (_e1939 < 1073741800f));
let _e1948 = select(0i, select(select(i32(_e1941), i32(-2147483648), (_e1941 < -2147483600f)), 2147483647i, (_e1941 > 2147483500f)), (_e1941 == _e1941));
let _e1952 = (_e1948 - select(0i, 1i, (_e1941 < f32(_e1948))));
let _e1953 = select(0i, 20i, _e1933);
let _e1957 = (bitcast<u32>(_e1952) << bitcast<u32>((_e1953 & 31i)));
let _e1964 = bitcast<u32>(((_e1952 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1953) & 31i))));
let _e1968 = (bitcast<f32>((bitcast<u32>(_e1928) & 2147483647u)) >= 1073741800f);
let _e1971 = ((_e1928 * select(1f, _e1934, _e1968)) + 0.5f);
let _e1973 = select(-1073741800f, _e1971, (_e1971 > -1073741800f));
let _e1975 = select(1073741800f, _e1973, (_e1973 < 1073741800f));
let _e1982 = select(0i, select(select(i32(_e1975), i32(-2147483648), (_e1975 < -2147483600f)), 2147483647i, (_e1975 > 2147483500f)), (_e1975 == _e1975));
let _e1986 = (_e1982 - select(0i, 1i, (_e1975 < f32(_e1982))));
let _e1987 = select(0i, 20i, _e1968);
let _e1991 = (bitcast<u32>(_e1986) << bitcast<u32>((_e1987 & 31i)));
let _e1998 = bitcast<u32>(((_e1986 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e1987) & 31i))));
let _e2002 = (bitcast<f32>((bitcast<u32>(_e1929) & 2147483647u)) >= 1073741800f);
let _e2005 = ((_e1929 * select(1f, _e1934, _e2002)) + 0.5f);
let _e2007 = select(-1073741800f, _e2005, (_e2005 > -1073741800f));
let _e2009 = select(1073741800f, _e2007, (_e2007 < 1073741800f));
let _e2016 = select(0i, select(select(i32(_e2009), i32(-2147483648), (_e2009 < -2147483600f)), 2147483647i, (_e2009 > 2147483500f)), (_e2009 == _e2009));
let _e2020 = (_e2016 - select(0i, 1i, (_e2009 < f32(_e2016))));
let _e2021 = select(0i, 20i, _e2002);
let _e2025 = (bitcast<u32>(_e2020) << bitcast<u32>((_e2021 & 31i)));
let _e2032 = bitcast<u32>(((_e2020 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e2021) & 31i))));
let _e2037 = bitcast<i32>(bitcast<u32>((((_e1916.member_1 * _e934) + _e1916.member) * 6i)));
if ((_e1957 | _e1964) == 0u) {
} else {
let _e2040 = bitcast<u32>(_e2037);
if (_e2040 < _e269) {
let _e2044 = atomicAdd((&global_8.member[_e2040]), _e1957);
phi_3850_ = _e2044;
} else {
phi_3850_ = 0u;
}
let _e2046 = phi_3850_;
let _e2050 = (_e1964 + select(0u, 1u, ((_e2046 + _e1957) < _e1957)));
if (_e2050 == 0u) {
} else {
let _e2052 = (_e2040 + 1u);
if (_e2052 < _e269) {
let _e2056 = atomicAdd((&global_8.member[_e2052]), _e2050);
}
}
}
if ((_e1991 | _e1998) == 0u) {
} else {
let _e2060 = bitcast<u32>((_e2037 + 2i));
if (_e2060 < _e269) {
let _e2064 = atomicAdd((&global_8.member[_e2060]), _e1991);
phi_3880_ = _e2064;
} else {
phi_3880_ = 0u;
}
let _e2066 = phi_3880_;
let _e2070 = (_e1998 + select(0u, 1u, ((_e2066 + _e1991) < _e1991)));
if (_e2070 == 0u) {
} else {
let _e2072 = (_e2060 + 1u);
if (_e2072 < _e269) {
let _e2076 = atomicAdd((&global_8.member[_e2072]), _e2070);
}
}
}
if ((_e2025 | _e2032) == 0u) {
} else {
let _e2080 = bitcast<u32>((_e2037 + 4i));
if (_e2080 < _e269) {
let _e2084 = atomicAdd((&global_8.member[_e2080]), _e2025);
phi_3910_ = _e2084;
} else {
phi_3910_ = 0u;
}
let _e2086 = phi_3910_;
let _e2090 = (_e2032 + select(0u, 1u, ((_e2086 + _e2025) < _e2025)));
if (_e2090 == 0u) {
} else {
let _e2092 = (_e2080 + 1u);
if (_e2092 < _e269) {
let _e2096 = atomicAdd((&global_8.member[_e2092]), _e2090);
}
}
}
phi_2363_ = (_e1095 + 1i);
} else {
phi_2363_ = i32();
}
let _e2099 = phi_2363_;
continue;
continuing {
phi_2362_ = _e2099;
break if !(_e1098);
}
}
phi_2209_ = (_e1002 + 1i);
} else {
phi_2209_ = i32();
}
let _e2103 = phi_2209_;
continue;
continuing {
phi_2208_ = _e2103;
break if !(_e1003);
}
}
} else {
if (_e999 == 1u) {
phi_3959_ = 0i;
loop {
let _e2107 = phi_3959_;
let _e2108 = (_e2107 < 16i);
if _e2108 {
let _e2110 = (_e979 + (_e2107 & 15i));
let _e2112 = (f32(_e2110) + 0.5f);
let _e2114 = ((_e2112 * 1f) - 0.5f);
let _e2118 = (-(((_e415 * _e2114) + _e441)) / _e428);
let _e2125 = bitcast<f32>((bitcast<u32>(((_e465 * _e2114) + ((_e478 * _e2118) + _e491))) & 2147483647u));
let _e2132 = bitcast<f32>((bitcast<u32>(((_e504 * _e2114) + ((_e517 * _e2118) + _e530))) & 2147483647u));
let _e2136 = (((0.5f * (_e2125 + _e2132)) / _e533) + _e716);
let _e2137 = (1f / 1f);
let _e2145 = ((((_e2118 + _e2136) + 0.5f) * _e2137) - 0.5f);
let _e2146 = f32(_e984);
let _e2147 = (0f - 1f);
let _e2149 = select(_e2147, _e2145, (_e2145 > _e2147));
let _e2151 = select(_e2146, _e2149, (_e2149 < _e2146));
let _e2158 = select(0i, select(select(i32(_e2151), i32(-2147483648), (_e2151 < -2147483600f)), 2147483647i, (_e2151 > 2147483500f)), (_e2151 == _e2151));
let _e2163 = (((((_e2118 - _e2136) + 0.5f) * _e2137) - 0.5f) + 1f);
let _e2164 = (_e2146 + 1f);
let _e2166 = select(0f, _e2163, (_e2163 > 0f));
let _e2168 = select(_e2164, _e2166, (_e2166 < _e2164));
let _e2175 = select(0i, select(select(i32(_e2168), i32(-2147483648), (_e2168 < -2147483600f)), 2147483647i, (_e2168 > 2147483500f)), (_e2168 == _e2168));
let _e2186 = ((1e-4f * 1f) * _e533);
let _e2188 = select(_e2132, _e2125, (_e2125 > _e2132));
let _e2190 = select(_e2186, _e2188, (_e2188 > _e2186));
let _e2192 = select(_e2132, _e2125, (_e2125 < _e2132));
let _e2194 = select(_e2186, _e2192, (_e2192 > _e2186));
let _e2196 = (0.5f * (_e2190 + _e2194));
let _e2197 = (0.5f / _e2194);
let _e2198 = (1f / _e2190);
phi_4113_ = 0i;
loop {
let _e2200 = phi_4113_;
let _e2202 = (((_e2175 - select(0i, 1i, (_e2168 < f32(_e2175)))) + (_e2107 >> bitcast<u32>(4u))) + bitcast<i32>(_e2200));
let _e2203 = (_e2202 <= select(-1i, (_e2158 - select(0i, 1i, (_e2151 < f32(_e2158)))), (_e2110 <= _e983)));
if _e2203 {
let _e2205 = (f32(_e2202) + 0.5f);
let _e2209 = ((((_e2205 * 1f) - 0.5f) - _e2118) * _e533);
let _e2210 = (_e533 * 1f);
let _e2212 = (0.5f * _e2210);
let _e2213 = (_e2209 + _e2212);
let _e2214 = -(_e2213);
let _e2217 = (_e2196 - select(_e2214, _e2213, (_e2213 > _e2214)));
let _e2219 = select(0f, _e2217, (_e2217 > 0f));
let _e2221 = select(_e2194, _e2219, (_e2219 < _e2194));
let _e2224 = (_e2217 - _e2194);
let _e2228 = (((_e2221 * (_e2221 * _e2197)) + select(0f, _e2224, (_e2224 > 0f))) * _e2198);
let _e2232 = (_e2209 - _e2212);
let _e2233 = -(_e2232);
let _e2236 = (_e2196 - select(_e2233, _e2232, (_e2232 > _e2233)));
let _e2238 = select(0f, _e2236, (_e2236 > 0f));
let _e2240 = select(_e2194, _e2238, (_e2238 < _e2194));
let _e2243 = (_e2236 - _e2194);
let _e2247 = (((_e2240 * (_e2240 * _e2197)) + select(0f, _e2243, (_e2243 > 0f))) * _e2198);
if _e452 {
phi_4218_ = type_23(_e2202, _e2110);
} else {
phi_4218_ = type_23(_e2110, _e2202);
}
let _e2256 = phi_4218_;
let _e2260 = bitcast<i32>((_e930 * _e933));
local_204 = _e2260;
local_205 = ((_e2256.member_1 * _e934) + _e2256.member);
let _e2263 = local_204;
let _e2264 = local_205;
let _e2265 = (_e2263 + _e2264);
let _e2267 = (bitcast<i32>(_e258) - 1i);
let _e2269 = select(_e2267, _e2265, (_e2265 < _e2267));
let _e2274 = global_5.member[bitcast<u32>(select(0i, _e2269, (_e2269 > 0i)))];
let _e2275 = local_204;
let _e2277 = local_205;
let _e2278 = ((2i * _e2275) + _e2277);
let _e2280 = select(_e2267, _e2278, (_e2278 < _e2267));
let _e2285 = global_5.member[bitcast<u32>(select(0i, _e2280, (_e2280 > 0i)))];
let _e2286 = local_205;
let _e2288 = select(_e2267, _e2286, (_e2286 < _e2267));
let _e2293 = global_5.member[bitcast<u32>(select(0i, _e2288, (_e2288 > 0i)))];
let _e2294 = local_205;
let _e2297 = f32(_e934);
let _e2298 = f32(_e935);
let _e2305 = global_1.member.member_2.member;
let _e2306 = (((((f32(_e2256.member) + 0.5f) / _e2297) * 2f) - 1f) * _e2305);
let _e2313 = global_1.member.member_2.member_1;
let _e2314 = ((1f - (((f32(_e2256.member_1) + 0.5f) / _e2298) * 2f)) * _e2313);
let _e2316 = global_1.member.member_3;
let _e2324 = global_1.member.member_4;
let _e2331 = ((_e2316.member * _e2306) + (_e2324.member * _e2314));
let _e2332 = ((_e2316.member_1 * _e2306) + (_e2324.member_1 * _e2314));
let _e2333 = ((_e2316.member_2 * _e2306) + (_e2324.member_2 * _e2314));
let _e2336 = global_1.member.member_2.member_3;
let _e2337 = (_e2336 != 0u);
let _e2339 = global_1.member.member_5;
let _e2346 = select((_e2339.member + _e2331), _e2339.member, _e2337);
let _e2347 = select((_e2339.member_1 + _e2332), _e2339.member_1, _e2337);
let _e2348 = select((_e2339.member_2 + _e2333), _e2339.member_2, _e2337);
let _e2350 = global_1.member.member_6;
let _e2357 = select(_e2350.member, (_e2350.member + _e2331), _e2337);
let _e2358 = select(_e2350.member_1, (_e2350.member_1 + _e2332), _e2337);
let _e2359 = select(_e2350.member_2, (_e2350.member_2 + _e2333), _e2337);
let _e2364 = (((_e2346 * _e2346) + (_e2347 * _e2347)) + (_e2348 * _e2348));
let _e2367 = sqrt(select(0f, _e2364, (_e2364 > 0f)));
let _e2368 = (1f / _e2367);
let _e2369 = (_e2346 * _e2368);
let _e2370 = (_e2347 * _e2368);
let _e2371 = (_e2348 * _e2368);
let _e2372 = (_e574 - _e2357);
let _e2373 = (_e586 - _e2358);
let _e2374 = (_e599 - _e2359);
let _e2379 = (((_e2372 * _e2369) + (_e2373 * _e2370)) + (_e2374 * _e2371));
let _e2384 = (((_e2372 * _e612) + (_e2373 * _e625)) + (_e2374 * _e638));
let _e2389 = (((_e2369 * _e612) + (_e2370 * _e625)) + (_e2371 * _e638));
let _e2392 = ((_e2370 * _e638) - (_e2371 * _e625));
let _e2395 = ((_e2371 * _e612) - (_e2369 * _e638));
let _e2398 = ((_e2369 * _e625) - (_e2370 * _e612));
let _e2403 = (((_e2392 * _e2392) + (_e2395 * _e2395)) + (_e2398 * _e2398));
let _e2406 = (1f / select(1e-9f, _e2403, (_e2403 > 1e-9f)));
let _e2409 = ((_e2379 - (_e2389 * _e2384)) * _e2406);
let _e2412 = (((_e2389 * _e2379) - _e2384) * _e2406);
let _e2418 = -(_e2389);
let _e2421 = global_1.member.member_13.member_2;
let _e2422 = (_e2421 * _e2421);
let _e2426 = ((1f + _e2422) - ((2f * _e2421) * _e2418));
let _e2428 = select(1e-9f, _e2426, (_e2426 > 1e-9f));
let _e2440 = global_1.member.member_13.member_3;
let _e2448 = global_1.member.member_12.member_10;
let _e2451 = global_1.member.member_12.member_4;
let _e2454 = global_1.member.member_12.member_11;
let _e2460 = global_1.member.member.member;
let _e2462 = (_e2412 / _e690);
local_201 = bitcast<i32>((_e2448 + (_e2451 * _e2454)));
local_202 = _e280;
local_203 = bitcast<i32>(_e2460);
let _e2465 = global_1.member.member_13.member_6;
let _e2466 = f32(_e2465);
let _e2468 = select(0f, _e2462, (_e2462 > 0f));
let _e2471 = (select(1f, _e2468, (_e2468 < 1f)) * _e2466);
let _e2472 = (_e2466 - 1f);
let _e2474 = select(0f, _e2472, (_e2472 > 0f));
let _e2476 = select(0f, _e2471, (_e2471 > 0f));
let _e2478 = select(_e2474, _e2476, (_e2476 < _e2474));
let _e2485 = select(0i, select(select(i32(_e2478), i32(-2147483648), (_e2478 < -2147483600f)), 2147483647i, (_e2478 > 2147483500f)), (_e2478 == _e2478));
let _e2489 = (_e2485 - select(0i, 1i, (_e2478 < f32(_e2485))));
if (_e2489 > 0i) {
let _e2492 = local_201;
let _e2493 = local_203;
let _e2496 = local_202;
let _e2497 = ((_e2492 + ((_e2489 - 1i) * _e2493)) + _e2496);
let _e2499 = (bitcast<i32>(_e267) - 1i);
let _e2501 = select(_e2499, _e2497, (_e2497 < _e2499));
let _e2506 = global_7.member[bitcast<u32>(select(0i, _e2501, (_e2501 > 0i)))];
phi_4631_ = _e2506;
} else {
phi_4631_ = 0f;
}
let _e2508 = phi_4631_;
let _e2509 = local_201;
let _e2510 = local_203;
let _e2513 = local_202;
let _e2514 = ((_e2509 + (_e2489 * _e2510)) + _e2513);
let _e2516 = (bitcast<i32>(_e267) - 1i);
let _e2518 = select(_e2516, _e2514, (_e2514 < _e2516));
let _e2523 = global_7.member[bitcast<u32>(select(0i, _e2518, (_e2518 > 0i)))];
let _e2530 = (_e2285 - _e2274);
let _e2533 = ((_e2409 - _e2274) / select(1e-9f, _e2530, (_e2530 > 1e-9f)));
local_198 = 0i;
local_199 = _e2294;
local_200 = _e2260;
let _e2535 = select(0f, _e2533, (_e2533 > 0f));
let _e2538 = (select(1f, _e2535, (_e2535 < 1f)) * _e2466);
let _e2540 = select(0f, _e2538, (_e2538 > 0f));
let _e2542 = select(_e2474, _e2540, (_e2540 < _e2474));
let _e2549 = select(0i, select(select(i32(_e2542), i32(-2147483648), (_e2542 < -2147483600f)), 2147483647i, (_e2542 > 2147483500f)), (_e2542 == _e2542));
let _e2553 = (_e2549 - select(0i, 1i, (_e2542 < f32(_e2549))));
if (_e2553 > 0i) {
let _e2556 = local_198;
let _e2557 = local_200;
let _e2560 = local_199;
let _e2561 = ((_e2556 + ((_e2553 - 1i) * _e2557)) + _e2560);
let _e2563 = select(_e2516, _e2561, (_e2561 < _e2516));
let _e2568 = global_7.member[bitcast<u32>(select(0i, _e2563, (_e2563 > 0i)))];
phi_4758_ = _e2568;
} else {
phi_4758_ = 0f;
}
let _e2570 = phi_4758_;
let _e2571 = local_198;
let _e2572 = local_200;
let _e2575 = local_199;
let _e2576 = ((_e2571 + (_e2553 * _e2572)) + _e2575);
let _e2578 = select(_e2516, _e2576, (_e2576 < _e2516));
let _e2583 = global_7.member[bitcast<u32>(select(0i, _e2578, (_e2578 > 0i)))];
let _e2589 = ((_e2508 + ((_e2523 - _e2508) * (_e2471 - f32(_e2489)))) + (_e2570 + ((_e2583 - _e2570) * (_e2538 - f32(_e2553)))));
let _e2598 = global_1.member.member_13.member_7;
let _e2599 = bitcast<i32>(_e2598);
let _e2602 = global_1.member.member_13.member_8;
let _e2603 = bitcast<i32>(_e2602);
let _e2606 = global_1.member.member_13.member_9;
let _e2607 = bitcast<i32>(_e2606);
let _e2610 = global_1.member.member_13.member_4;
let _e2616 = global_1.member.member_13.member_5;
let _e2620 = f32(_e2599);
let _e2625 = (((((_e2357 + (_e2369 * _e2409)) - _e2610.member) / (_e2616.member - _e2610.member)) * _e2620) - 0.5f);
let _e2626 = (_e2620 - 1f);
let _e2628 = select(0f, _e2625, (_e2625 > 0f));
let _e2630 = select(_e2626, _e2628, (_e2628 < _e2626));
let _e2631 = f32(_e2603);
let _e2636 = (((((_e2358 + (_e2370 * _e2409)) - _e2610.member_1) / (_e2616.member_1 - _e2610.member_1)) * _e2631) - 0.5f);
let _e2637 = (_e2631 - 1f);
let _e2639 = select(0f, _e2636, (_e2636 > 0f));
let _e2641 = select(_e2637, _e2639, (_e2639 < _e2637));
let _e2642 = f32(_e2607);
let _e2647 = (((((_e2359 + (_e2371 * _e2409)) - _e2610.member_2) / (_e2616.member_2 - _e2610.member_2)) * _e2642) - 0.5f);
let _e2648 = (_e2642 - 1f);
let _e2650 = select(0f, _e2647, (_e2647 > 0f));
let _e2652 = select(_e2648, _e2650, (_e2650 < _e2648));
let _e2654 = select(0f, _e2630, (_e2630 > 0f));
let _e2656 = select(1e6f, _e2654, (_e2654 < 1e6f));
let _e2663 = select(0i, select(select(i32(_e2656), i32(-2147483648), (_e2656 < -2147483600f)), 2147483647i, (_e2656 > 2147483500f)), (_e2656 == _e2656));
let _e2667 = (_e2663 - select(0i, 1i, (_e2656 < f32(_e2663))));
let _e2669 = select(0f, _e2641, (_e2641 > 0f));
let _e2671 = select(1e6f, _e2669, (_e2669 < 1e6f));
let _e2678 = select(0i, select(select(i32(_e2671), i32(-2147483648), (_e2671 < -2147483600f)), 2147483647i, (_e2671 > 2147483500f)), (_e2671 == _e2671));
let _e2682 = (_e2678 - select(0i, 1i, (_e2671 < f32(_e2678))));
let _e2684 = select(0f, _e2652, (_e2652 > 0f));
let _e2686 = select(1e6f, _e2684, (_e2684 < 1e6f));
let _e2693 = select(0i, select(select(i32(_e2686), i32(-2147483648), (_e2686 < -2147483600f)), 2147483647i, (_e2686 > 2147483500f)), (_e2686 == _e2686));
let _e2697 = (_e2693 - select(0i, 1i, (_e2686 < f32(_e2693))));
let _e2701 = (_e2641 - f32(_e2682));
let _e2703 = (_e2652 - f32(_e2697));
local_196 = (_e2630 - f32(_e2667));
let _e2704 = (_e2667 + 1i);
let _e2706 = select(_e2704, 0i, (_e2704 < 0i));
if (_e2706 >= _e2599) {
phi_4906_ = (_e2599 - 1i);
} else {
phi_4906_ = _e2706;
}
let _e2710 = phi_4906_;
local_197 = (_e2710 - _e2667);
let _e2712 = (_e2682 + 1i);
let _e2714 = select(_e2712, 0i, (_e2712 < 0i));
if (_e2714 >= _e2603) {
phi_4919_ = (_e2603 - 1i);
} else {
phi_4919_ = _e2714;
}
let _e2718 = phi_4919_;
let _e2720 = ((_e2718 - _e2682) * _e2599);
let _e2721 = (_e2697 + 1i);
let _e2723 = select(_e2721, 0i, (_e2721 < 0i));
if (_e2723 >= _e2607) {
phi_4933_ = (_e2607 - 1i);
} else {
phi_4933_ = _e2723;
}
let _e2727 = phi_4933_;
let _e2733 = global_1.member.member_13.member_10;
let _e2739 = ((bitcast<i32>(_e2733) + (((_e2697 * _e2603) + _e2682) * _e2599)) + _e2667);
let _e2741 = (bitcast<i32>(_e264) - 1i);
let _e2743 = select(_e2741, _e2739, (_e2739 < _e2741));
let _e2748 = global_2.member[bitcast<u32>(select(0i, _e2743, (_e2743 > 0i)))];
let _e2749 = local_196;
let _e2752 = local_197;
let _e2753 = (_e2739 + _e2752);
let _e2755 = select(_e2741, _e2753, (_e2753 < _e2741));
let _e2760 = global_2.member[bitcast<u32>(select(0i, _e2755, (_e2755 > 0i)))];
let _e2761 = local_196;
let _e2764 = (1f - _e2701);
let _e2766 = (_e2739 + _e2720);
let _e2768 = select(_e2741, _e2766, (_e2766 < _e2741));
let _e2773 = global_2.member[bitcast<u32>(select(0i, _e2768, (_e2768 > 0i)))];
let _e2774 = local_196;
let _e2777 = local_197;
let _e2778 = (_e2766 + _e2777);
let _e2780 = select(_e2741, _e2778, (_e2778 < _e2741));
let _e2785 = global_2.member[bitcast<u32>(select(0i, _e2780, (_e2780 > 0i)))];
let _e2786 = local_196;
let _e2791 = (_e2739 + (((_e2727 - _e2697) * _e2599) * _e2603));
let _e2793 = select(_e2741, _e2791, (_e2791 < _e2741));
let _e2798 = global_2.member[bitcast<u32>(select(0i, _e2793, (_e2793 > 0i)))];
let _e2799 = local_196;
let _e2802 = local_197;
let _e2803 = (_e2791 + _e2802);
let _e2805 = select(_e2741, _e2803, (_e2803 < _e2741));
let _e2810 = global_2.member[bitcast<u32>(select(0i, _e2805, (_e2805 > 0i)))];
let _e2811 = local_196;
let _e2815 = (_e2791 + _e2720);
let _e2817 = select(_e2741, _e2815, (_e2815 < _e2741));
let _e2822 = global_2.member[bitcast<u32>(select(0i, _e2817, (_e2817 > 0i)))];
let _e2823 = local_196;
let _e2826 = local_197;
let _e2827 = (_e2815 + _e2826);
let _e2829 = select(_e2741, _e2827, (_e2827 < _e2741));
let _e2834 = global_2.member[bitcast<u32>(select(0i, _e2829, (_e2829 > 0i)))];
let _e2835 = local_196;
let _e2844 = ((_e2367 * (select(((1f - _e2422) / (_e2428 * sqrt(select(0f, _e2428, (_e2428 > 0f))))), (0.75f * (1f + (_e2418 * _e2418))), (_e2440 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e2748 * (1f - _e2749)) + (_e2760 * _e2761)) * _e2764) + (((_e2773 * (1f - _e2774)) + (_e2785 * _e2786)) * _e2701)) * (1f - _e2703)) + (((((_e2798 * (1f - _e2799)) + (_e2810 * _e2811)) * _e2764) + (((_e2822 * (1f - _e2823)) + (_e2834 * _e2835)) * _e2701)) * _e2703)));
let _e2847 = global_1.member.member_13.member_1;
let _e2856 = global_1.member.member_13.member;
let _e2861 = -((_e2856.member * _e2589));
let _e2863 = select(-87f, _e2861, (_e2861 > -87f));
let _e2865 = select(88f, _e2863, (_e2863 < 88f));
let _e2867 = ((_e2865 * 1.442695f) + 0.5f);
let _e2869 = select(-127f, _e2867, (_e2867 > -127f));
let _e2871 = select(128f, _e2869, (_e2869 < 128f));
let _e2878 = select(0i, select(select(i32(_e2871), i32(-2147483648), (_e2871 < -2147483600f)), 2147483647i, (_e2871 > 2147483500f)), (_e2871 == _e2871));
let _e2882 = (_e2878 - select(0i, 1i, (_e2871 < f32(_e2878))));
let _e2883 = f32(_e2882);
let _e2887 = ((_e2865 - (_e2883 * 0.6933594f)) - (_e2883 * -2.1219444e-4f));
let _e2909 = -((_e2856.member_1 * _e2589));
let _e2911 = select(-87f, _e2909, (_e2909 > -87f));
let _e2913 = select(88f, _e2911, (_e2911 < 88f));
let _e2915 = ((_e2913 * 1.442695f) + 0.5f);
let _e2917 = select(-127f, _e2915, (_e2915 > -127f));
let _e2919 = select(128f, _e2917, (_e2917 < 128f));
let _e2926 = select(0i, select(select(i32(_e2919), i32(-2147483648), (_e2919 < -2147483600f)), 2147483647i, (_e2919 > 2147483500f)), (_e2919 == _e2919));
let _e2930 = (_e2926 - select(0i, 1i, (_e2919 < f32(_e2926))));
let _e2931 = f32(_e2930);
let _e2935 = ((_e2913 - (_e2931 * 0.6933594f)) - (_e2931 * -2.1219444e-4f));
let _e2957 = -((_e2856.member_2 * _e2589));
let _e2959 = select(-87f, _e2957, (_e2957 > -87f));
let _e2961 = select(88f, _e2959, (_e2959 < 88f));
let _e2963 = ((_e2961 * 1.442695f) + 0.5f);
let _e2965 = select(-127f, _e2963, (_e2963 > -127f));
let _e2967 = select(128f, _e2965, (_e2965 < 128f));
let _e2974 = select(0i, select(select(i32(_e2967), i32(-2147483648), (_e2967 < -2147483600f)), 2147483647i, (_e2967 > 2147483500f)), (_e2967 == _e2967));
let _e2978 = (_e2974 - select(0i, 1i, (_e2967 < f32(_e2974))));
let _e2979 = f32(_e2978);
let _e2983 = ((_e2961 - (_e2979 * 0.6933594f)) - (_e2979 * -2.1219444e-4f));
let _e3010 = select(0f, _e2409, (((_e2412 >= 0f) && (_e2412 < _e690)) && (_e2409 > 0f)));
let _e3012 = ((_e765 + _e987) + _e991);
let _e3013 = (_e3012 & 31u);
let _e3015 = (1u << bitcast<u32>(_e3013));
let _e3024 = bitcast<i32>((((_e930 + _e3015) - 1u) >> bitcast<u32>(_e3013)));
let _e3025 = bitcast<i32>((((_e933 + _e3015) - 1u) >> bitcast<u32>(_e3013)));
if _e452 {
phi_5394_ = type_23(_e3025, _e3024);
} else {
phi_5394_ = type_23(_e3024, _e3025);
}
let _e3029 = phi_5394_;
let _e3034 = f32((1i << bitcast<u32>(_e3013)));
let _e3035 = (1f / _e3034);
let _e3037 = ((_e2112 * _e3035) - 0.5f);
let _e3039 = ((_e2205 * _e3035) - 0.5f);
let _e3041 = select(-1f, _e3037, (_e3037 > -1f));
let _e3043 = select(1e6f, _e3041, (_e3041 < 1e6f));
let _e3050 = select(0i, select(select(i32(_e3043), i32(-2147483648), (_e3043 < -2147483600f)), 2147483647i, (_e3043 > 2147483500f)), (_e3043 == _e3043));
let _e3054 = (_e3050 - select(0i, 1i, (_e3043 < f32(_e3050))));
let _e3056 = select(-1f, _e3039, (_e3039 > -1f));
let _e3058 = select(1e6f, _e3056, (_e3056 < 1e6f));
let _e3065 = select(0i, select(select(i32(_e3058), i32(-2147483648), (_e3058 < -2147483600f)), 2147483647i, (_e3058 > 2147483500f)), (_e3058 == _e3058));
let _e3069 = (_e3065 - select(0i, 1i, (_e3058 < f32(_e3065))));
let _e3071 = (_e3037 - f32(_e3054));
let _e3073 = (_e3039 - f32(_e3069));
let _e3074 = (1f - _e3071);
let _e3075 = (1f - _e3073);
let _e3078 = select(_e3054, 0i, (_e3054 < 0i));
let _e3079 = (_e3078 >= _e3029.member);
if _e3079 {
phi_5472_ = (_e3029.member - 1i);
} else {
phi_5472_ = _e3078;
}
let _e3082 = phi_5472_;
let _e3084 = select(_e3069, 0i, (_e3069 < 0i));
let _e3085 = (_e3084 >= _e3029.member_1);
if _e3085 {
phi_5483_ = (_e3029.member_1 - 1i);
} else {
phi_5483_ = _e3084;
}
let _e3088 = phi_5483_;
let _e3092 = (((f32(_e3082) + 0.5f) * _e3034) - 0.5f);
let _e3096 = (((f32(_e3088) + 0.5f) * _e3034) - 0.5f);
if _e452 {
phi_5511_ = type_23(_e3088, _e3082);
} else {
phi_5511_ = type_23(_e3082, _e3088);
}
let _e3102 = phi_5511_;
let _e3108 = bitcast<i32>(((_e930 + 1u) >> bitcast<u32>(1u)));
let _e3111 = global_1.member.member_18.member_6;
let _e3114 = global_1.member.member_18.member_7;
let _e3117 = global_1.member.member_18.member_8;
let _e3118 = (_e3012 == 0u);
if _e3118 {
phi_5562_ = 0u;
} else {
if (_e3012 == 1u) {
phi_5561_ = 0u;
} else {
if (_e3012 == 2u) {
phi_5560_ = _e3111;
} else {
phi_5560_ = select(_e3117, _e3114, (_e3012 == 3u));
}
let _e3124 = phi_5560_;
phi_5561_ = _e3124;
}
let _e3126 = phi_5561_;
phi_5562_ = _e3126;
}
let _e3128 = phi_5562_;
local_194 = (((bitcast<i32>(_e3128) + _e3102.member_1) * _e3108) + _e3102.member);
let _e3133 = local_194;
let _e3135 = (bitcast<i32>(_e261) - 1i);
let _e3137 = select(_e3135, _e3133, (_e3133 < _e3135));
let _e3142 = global_6.member[bitcast<u32>(select(0i, _e3137, (_e3137 > 0i)))];
let _e3147 = (((((select(_e3092, _e3096, _e452) + 0.5f) / _e2297) * 2f) - 1f) * _e2305);
let _e3152 = ((1f - (((select(_e3096, _e3092, _e452) + 0.5f) / _e2298) * 2f)) * _e2313);
let _e3159 = ((_e2316.member * _e3147) + (_e2324.member * _e3152));
let _e3160 = ((_e2316.member_1 * _e3147) + (_e2324.member_1 * _e3152));
let _e3161 = ((_e2316.member_2 * _e3147) + (_e2324.member_2 * _e3152));
let _e3165 = select((_e2339.member + _e3159), _e2339.member, _e2337);
let _e3166 = select((_e2339.member_1 + _e3160), _e2339.member_1, _e2337);
let _e3167 = select((_e2339.member_2 + _e3161), _e2339.member_2, _e2337);
let _e3178 = (((_e3165 * _e3165) + (_e3166 * _e3166)) + (_e3167 * _e3167));
let _e3182 = (1f / sqrt(select(0f, _e3178, (_e3178 > 0f))));
let _e3183 = (_e3165 * _e3182);
let _e3184 = (_e3166 * _e3182);
let _e3185 = (_e3167 * _e3182);
let _e3186 = (_e574 - select(_e2350.member, (_e2350.member + _e3159), _e2337));
let _e3187 = (_e586 - select(_e2350.member_1, (_e2350.member_1 + _e3160), _e2337));
let _e3188 = (_e599 - select(_e2350.member_2, (_e2350.member_2 + _e3161), _e2337));
let _e3193 = (((_e3186 * _e3183) + (_e3187 * _e3184)) + (_e3188 * _e3185));
let _e3198 = (((_e3186 * _e612) + (_e3187 * _e625)) + (_e3188 * _e638));
let _e3203 = (((_e3183 * _e612) + (_e3184 * _e625)) + (_e3185 * _e638));
let _e3206 = ((_e3184 * _e638) - (_e3185 * _e625));
let _e3209 = ((_e3185 * _e612) - (_e3183 * _e638));
let _e3212 = ((_e3183 * _e625) - (_e3184 * _e612));
let _e3217 = (((_e3206 * _e3206) + (_e3209 * _e3209)) + (_e3212 * _e3212));
let _e3220 = (1f / select(1e-9f, _e3217, (_e3217 > 1e-9f)));
let _e3223 = ((_e3193 - (_e3203 * _e3198)) * _e3220);
let _e3226 = (((_e3203 * _e3193) - _e3198) * _e3220);
let _e3232 = select(0f, _e3223, (((_e3226 >= 0f) && (_e3226 < _e690)) && (_e3223 > 0f)));
let _e3234 = (_e3082 << bitcast<u32>(_e3013));
let _e3246 = (_e3054 + 1i);
let _e3249 = select(_e3246, 0i, (_e3246 < 0i));
let _e3250 = (_e3249 >= _e3029.member);
if _e3250 {
phi_6109_ = (_e3029.member - 1i);
} else {
phi_6109_ = _e3249;
}
let _e3253 = phi_6109_;
if _e3085 {
phi_6120_ = (_e3029.member_1 - 1i);
} else {
phi_6120_ = _e3084;
}
let _e3256 = phi_6120_;
let _e3260 = (((f32(_e3253) + 0.5f) * _e3034) - 0.5f);
let _e3264 = (((f32(_e3256) + 0.5f) * _e3034) - 0.5f);
if _e452 {
phi_6148_ = type_23(_e3256, _e3253);
} else {
phi_6148_ = type_23(_e3253, _e3256);
}
let _e3270 = phi_6148_;
if _e3118 {
phi_6199_ = 0u;
} else {
if (_e3012 == 1u) {
phi_6198_ = 0u;
} else {
if (_e3012 == 2u) {
phi_6197_ = _e3111;
} else {
phi_6197_ = select(_e3117, _e3114, (_e3012 == 3u));
}
let _e3278 = phi_6197_;
phi_6198_ = _e3278;
}
let _e3280 = phi_6198_;
phi_6199_ = _e3280;
}
let _e3282 = phi_6199_;
local_192 = (((bitcast<i32>(_e3282) + _e3270.member_1) * _e3108) + _e3270.member);
let _e3287 = local_192;
let _e3289 = select(_e3135, _e3287, (_e3287 < _e3135));
let _e3294 = global_6.member[bitcast<u32>(select(0i, _e3289, (_e3289 > 0i)))];
let _e3299 = (((((select(_e3260, _e3264, _e452) + 0.5f) / _e2297) * 2f) - 1f) * _e2305);
let _e3304 = ((1f - (((select(_e3264, _e3260, _e452) + 0.5f) / _e2298) * 2f)) * _e2313);
let _e3311 = ((_e2316.member * _e3299) + (_e2324.member * _e3304));
let _e3312 = ((_e2316.member_1 * _e3299) + (_e2324.member_1 * _e3304));
let _e3313 = ((_e2316.member_2 * _e3299) + (_e2324.member_2 * _e3304));
let _e3317 = select((_e2339.member + _e3311), _e2339.member, _e2337);
let _e3318 = select((_e2339.member_1 + _e3312), _e2339.member_1, _e2337);
let _e3319 = select((_e2339.member_2 + _e3313), _e2339.member_2, _e2337);
let _e3330 = (((_e3317 * _e3317) + (_e3318 * _e3318)) + (_e3319 * _e3319));
let _e3334 = (1f / sqrt(select(0f, _e3330, (_e3330 > 0f))));
let _e3335 = (_e3317 * _e3334);
let _e3336 = (_e3318 * _e3334);
let _e3337 = (_e3319 * _e3334);
let _e3338 = (_e574 - select(_e2350.member, (_e2350.member + _e3311), _e2337));
let _e3339 = (_e586 - select(_e2350.member_1, (_e2350.member_1 + _e3312), _e2337));
let _e3340 = (_e599 - select(_e2350.member_2, (_e2350.member_2 + _e3313), _e2337));
let _e3345 = (((_e3338 * _e3335) + (_e3339 * _e3336)) + (_e3340 * _e3337));
let _e3350 = (((_e3338 * _e612) + (_e3339 * _e625)) + (_e3340 * _e638));
let _e3355 = (((_e3335 * _e612) + (_e3336 * _e625)) + (_e3337 * _e638));
let _e3358 = ((_e3336 * _e638) - (_e3337 * _e625));
let _e3361 = ((_e3337 * _e612) - (_e3335 * _e638));
let _e3364 = ((_e3335 * _e625) - (_e3336 * _e612));
let _e3369 = (((_e3358 * _e3358) + (_e3361 * _e3361)) + (_e3364 * _e3364));
let _e3372 = (1f / select(1e-9f, _e3369, (_e3369 > 1e-9f)));
let _e3375 = ((_e3345 - (_e3355 * _e3350)) * _e3372);
let _e3378 = (((_e3355 * _e3345) - _e3350) * _e3372);
let _e3384 = select(0f, _e3375, (((_e3378 >= 0f) && (_e3378 < _e690)) && (_e3375 > 0f)));
let _e3386 = (_e3253 << bitcast<u32>(_e3013));
let _e3398 = (_e3069 + 1i);
if _e3079 {
phi_6746_ = (_e3029.member - 1i);
} else {
phi_6746_ = _e3078;
}
let _e3402 = phi_6746_;
let _e3404 = select(_e3398, 0i, (_e3398 < 0i));
let _e3405 = (_e3404 >= _e3029.member_1);
if _e3405 {
phi_6757_ = (_e3029.member_1 - 1i);
} else {
phi_6757_ = _e3404;
}
let _e3408 = phi_6757_;
let _e3412 = (((f32(_e3402) + 0.5f) * _e3034) - 0.5f);
let _e3416 = (((f32(_e3408) + 0.5f) * _e3034) - 0.5f);
if _e452 {
phi_6785_ = type_23(_e3408, _e3402);
} else {
phi_6785_ = type_23(_e3402, _e3408);
}
let _e3422 = phi_6785_;
if _e3118 {
phi_6836_ = 0u;
} else {
if (_e3012 == 1u) {
phi_6835_ = 0u;
} else {
if (_e3012 == 2u) {
phi_6834_ = _e3111;
} else {
phi_6834_ = select(_e3117, _e3114, (_e3012 == 3u));
}
let _e3430 = phi_6834_;
phi_6835_ = _e3430;
}
let _e3432 = phi_6835_;
phi_6836_ = _e3432;
}
let _e3434 = phi_6836_;
local_190 = (((bitcast<i32>(_e3434) + _e3422.member_1) * _e3108) + _e3422.member);
let _e3439 = local_190;
let _e3441 = select(_e3135, _e3439, (_e3439 < _e3135));
let _e3446 = global_6.member[bitcast<u32>(select(0i, _e3441, (_e3441 > 0i)))];
let _e3451 = (((((select(_e3412, _e3416, _e452) + 0.5f) / _e2297) * 2f) - 1f) * _e2305);
let _e3456 = ((1f - (((select(_e3416, _e3412, _e452) + 0.5f) / _e2298) * 2f)) * _e2313);
let _e3463 = ((_e2316.member * _e3451) + (_e2324.member * _e3456));
let _e3464 = ((_e2316.member_1 * _e3451) + (_e2324.member_1 * _e3456));
let _e3465 = ((_e2316.member_2 * _e3451) + (_e2324.member_2 * _e3456));
let _e3469 = select((_e2339.member + _e3463), _e2339.member, _e2337);
let _e3470 = select((_e2339.member_1 + _e3464), _e2339.member_1, _e2337);
let _e3471 = select((_e2339.member_2 + _e3465), _e2339.member_2, _e2337);
let _e3482 = (((_e3469 * _e3469) + (_e3470 * _e3470)) + (_e3471 * _e3471));
let _e3486 = (1f / sqrt(select(0f, _e3482, (_e3482 > 0f))));
let _e3487 = (_e3469 * _e3486);
let _e3488 = (_e3470 * _e3486);
let _e3489 = (_e3471 * _e3486);
let _e3490 = (_e574 - select(_e2350.member, (_e2350.member + _e3463), _e2337));
let _e3491 = (_e586 - select(_e2350.member_1, (_e2350.member_1 + _e3464), _e2337));
let _e3492 = (_e599 - select(_e2350.member_2, (_e2350.member_2 + _e3465), _e2337));
let _e3497 = (((_e3490 * _e3487) + (_e3491 * _e3488)) + (_e3492 * _e3489));
let _e3502 = (((_e3490 * _e612) + (_e3491 * _e625)) + (_e3492 * _e638));
let _e3507 = (((_e3487 * _e612) + (_e3488 * _e625)) + (_e3489 * _e638));
let _e3510 = ((_e3488 * _e638) - (_e3489 * _e625));
let _e3513 = ((_e3489 * _e612) - (_e3487 * _e638));
let _e3516 = ((_e3487 * _e625) - (_e3488 * _e612));
let _e3521 = (((_e3510 * _e3510) + (_e3513 * _e3513)) + (_e3516 * _e3516));
let _e3524 = (1f / select(1e-9f, _e3521, (_e3521 > 1e-9f)));
let _e3527 = ((_e3497 - (_e3507 * _e3502)) * _e3524);
let _e3530 = (((_e3507 * _e3497) - _e3502) * _e3524);
let _e3536 = select(0f, _e3527, (((_e3530 >= 0f) && (_e3530 < _e690)) && (_e3527 > 0f)));
let _e3538 = (_e3402 << bitcast<u32>(_e3013));
if _e3250 {
phi_7383_ = (_e3029.member - 1i);
} else {
phi_7383_ = _e3249;
}
let _e3553 = phi_7383_;
if _e3405 {
phi_7394_ = (_e3029.member_1 - 1i);
} else {
phi_7394_ = _e3404;
}
let _e3556 = phi_7394_;
let _e3560 = (((f32(_e3553) + 0.5f) * _e3034) - 0.5f);
let _e3564 = (((f32(_e3556) + 0.5f) * _e3034) - 0.5f);
if _e452 {
phi_7422_ = type_23(_e3556, _e3553);
} else {
phi_7422_ = type_23(_e3553, _e3556);
}
let _e3570 = phi_7422_;
if _e3118 {
phi_7473_ = 0u;
} else {
if (_e3012 == 1u) {
phi_7472_ = 0u;
} else {
if (_e3012 == 2u) {
phi_7471_ = _e3111;
} else {
phi_7471_ = select(_e3117, _e3114, (_e3012 == 3u));
}
let _e3578 = phi_7471_;
phi_7472_ = _e3578;
}
let _e3580 = phi_7472_;
phi_7473_ = _e3580;
}
let _e3582 = phi_7473_;
local_188 = (((bitcast<i32>(_e3582) + _e3570.member_1) * _e3108) + _e3570.member);
let _e3587 = local_188;
let _e3589 = select(_e3135, _e3587, (_e3587 < _e3135));
let _e3594 = global_6.member[bitcast<u32>(select(0i, _e3589, (_e3589 > 0i)))];
let _e3599 = (((((select(_e3560, _e3564, _e452) + 0.5f) / _e2297) * 2f) - 1f) * _e2305);
let _e3604 = ((1f - (((select(_e3564, _e3560, _e452) + 0.5f) / _e2298) * 2f)) * _e2313);
let _e3611 = ((_e2316.member * _e3599) + (_e2324.member * _e3604));
let _e3612 = ((_e2316.member_1 * _e3599) + (_e2324.member_1 * _e3604));
let _e3613 = ((_e2316.member_2 * _e3599) + (_e2324.member_2 * _e3604));
let _e3617 = select((_e2339.member + _e3611), _e2339.member, _e2337);
let _e3618 = select((_e2339.member_1 + _e3612), _e2339.member_1, _e2337);
let _e3619 = select((_e2339.member_2 + _e3613), _e2339.member_2, _e2337);
let _e3630 = (((_e3617 * _e3617) + (_e3618 * _e3618)) + (_e3619 * _e3619));
let _e3634 = (1f / sqrt(select(0f, _e3630, (_e3630 > 0f))));
let _e3635 = (_e3617 * _e3634);
let _e3636 = (_e3618 * _e3634);
let _e3637 = (_e3619 * _e3634);
let _e3638 = (_e574 - select(_e2350.member, (_e2350.member + _e3611), _e2337));
let _e3639 = (_e586 - select(_e2350.member_1, (_e2350.member_1 + _e3612), _e2337));
let _e3640 = (_e599 - select(_e2350.member_2, (_e2350.member_2 + _e3613), _e2337));
let _e3645 = (((_e3638 * _e3635) + (_e3639 * _e3636)) + (_e3640 * _e3637));
let _e3650 = (((_e3638 * _e612) + (_e3639 * _e625)) + (_e3640 * _e638));
let _e3655 = (((_e3635 * _e612) + (_e3636 * _e625)) + (_e3637 * _e638));
let _e3658 = ((_e3636 * _e638) - (_e3637 * _e625));
let _e3661 = ((_e3637 * _e612) - (_e3635 * _e638));
let _e3664 = ((_e3635 * _e625) - (_e3636 * _e612));
let _e3669 = (((_e3658 * _e3658) + (_e3661 * _e3661)) + (_e3664 * _e3664));
let _e3672 = (1f / select(1e-9f, _e3669, (_e3669 > 1e-9f)));
let _e3675 = ((_e3645 - (_e3655 * _e3650)) * _e3672);
let _e3678 = (((_e3655 * _e3645) - _e3650) * _e3672);
let _e3684 = select(0f, _e3675, (((_e3678 >= 0f) && (_e3678 < _e690)) && (_e3675 > 0f)));
let _e3686 = (_e3553 << bitcast<u32>(_e3013));
let _e3698 = select(((((1f - select(0f, (_e3074 * _e3075), (((select(select(_e765, _e926, (_e3234 >= _e691)), _e846, (_e3234 < _e297)) == _e3012) && (_e3232 > 0f)) && (_e3232 < _e3142)))) - select(0f, (_e3071 * _e3075), (((select(select(_e765, _e926, (_e3386 >= _e691)), _e846, (_e3386 < _e297)) == _e3012) && (_e3384 > 0f)) && (_e3384 < _e3294)))) - select(0f, (_e3074 * _e3073), (((select(select(_e765, _e926, (_e3538 >= _e691)), _e846, (_e3538 < _e297)) == _e3012) && (_e3536 > 0f)) && (_e3536 < _e3446)))) - select(0f, (_e3071 * _e3073), (((select(select(_e765, _e926, (_e3686 >= _e691)), _e846, (_e3686 < _e297)) == _e3012) && (_e3684 > 0f)) && (_e3684 < _e3594)))), 1f, _e3118);
if _e452 {
phi_8029_ = type_23(_e2202, _e2110);
} else {
phi_8029_ = type_23(_e2110, _e2202);
}
let _e3713 = phi_8029_;
let _e3716 = (_e2203 && (((_e3010 > 0f) && (_e3010 < _e2293)) && (bitcast<f32>((bitcast<u32>(_e3698) & 2147483647u)) > 1e-6f)));
let _e3719 = global_1.member.member_18.member;
let _e3720 = (((select(_e2228, (1f - _e2228), (_e2213 >= 0f)) - select(_e2247, (1f - _e2247), (_e2232 >= 0f))) * (1f / _e2210)) * _e3719);
let _e3724 = select(0f, (((((_e651 * _e2847.member) * ((1f + (_e2887 * (1f + (_e2887 * (0.5f + (_e2887 * (0.16666667f + (_e2887 * (0.041666668f + (_e2887 * (0.008333334f + (_e2887 * (0.001388889f + (_e2887 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2882 + 127i)) << bitcast<u32>(23i))))) * _e2844) * _e3698) * _e3720), _e3716);
let _e3725 = select(0f, (((((_e664 * _e2847.member_1) * ((1f + (_e2935 * (1f + (_e2935 * (0.5f + (_e2935 * (0.16666667f + (_e2935 * (0.041666668f + (_e2935 * (0.008333334f + (_e2935 * (0.001388889f + (_e2935 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2930 + 127i)) << bitcast<u32>(23i))))) * _e2844) * _e3698) * _e3720), _e3716);
let _e3726 = select(0f, (((((_e677 * _e2847.member_2) * ((1f + (_e2983 * (1f + (_e2983 * (0.5f + (_e2983 * (0.16666667f + (_e2983 * (0.041666668f + (_e2983 * (0.008333334f + (_e2983 * (0.001388889f + (_e2983 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e2978 + 127i)) << bitcast<u32>(23i))))) * _e2844) * _e3698) * _e3720), _e3716);
let _e3730 = (bitcast<f32>((bitcast<u32>(_e3724) & 2147483647u)) >= 1073741800f);
let _e3731 = (1f / 1048576f);
let _e3734 = ((_e3724 * select(1f, _e3731, _e3730)) + 0.5f);
let _e3736 = select(-1073741800f, _e3734, (_e3734 > -1073741800f));
let _e3738 = select(1073741800f, _e3736, (_e3736 < 1073741800f));
let _e3745 = select(0i, select(select(i32(_e3738), i32(-2147483648), (_e3738 < -2147483600f)), 2147483647i, (_e3738 > 2147483500f)), (_e3738 == _e3738));
let _e3749 = (_e3745 - select(0i, 1i, (_e3738 < f32(_e3745))));
let _e3750 = select(0i, 20i, _e3730);
let _e3754 = (bitcast<u32>(_e3749) << bitcast<u32>((_e3750 & 31i)));
let _e3761 = bitcast<u32>(((_e3749 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3750) & 31i))));
let _e3765 = (bitcast<f32>((bitcast<u32>(_e3725) & 2147483647u)) >= 1073741800f);
let _e3768 = ((_e3725 * select(1f, _e3731, _e3765)) + 0.5f);
let _e3770 = select(-1073741800f, _e3768, (_e3768 > -1073741800f));
let _e3772 = select(1073741800f, _e3770, (_e3770 < 1073741800f));
let _e3779 = select(0i, select(select(i32(_e3772), i32(-2147483648), (_e3772 < -2147483600f)), 2147483647i, (_e3772 > 2147483500f)), (_e3772 == _e3772));
let _e3783 = (_e3779 - select(0i, 1i, (_e3772 < f32(_e3779))));
let _e3784 = select(0i, 20i, _e3765);
let _e3788 = (bitcast<u32>(_e3783) << bitcast<u32>((_e3784 & 31i)));
let _e3795 = bitcast<u32>(((_e3783 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3784) & 31i))));
let _e3799 = (bitcast<f32>((bitcast<u32>(_e3726) & 2147483647u)) >= 1073741800f);
let _e3802 = ((_e3726 * select(1f, _e3731, _e3799)) + 0.5f);
let _e3804 = select(-1073741800f, _e3802, (_e3802 > -1073741800f));
let _e3806 = select(1073741800f, _e3804, (_e3804 < 1073741800f));
let _e3813 = select(0i, select(select(i32(_e3806), i32(-2147483648), (_e3806 < -2147483600f)), 2147483647i, (_e3806 > 2147483500f)), (_e3806 == _e3806));
let _e3817 = (_e3813 - select(0i, 1i, (_e3806 < f32(_e3813))));
let _e3818 = select(0i, 20i, _e3799);
let _e3822 = (bitcast<u32>(_e3817) << bitcast<u32>((_e3818 & 31i)));
let _e3829 = bitcast<u32>(((_e3817 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e3818) & 31i))));
let _e3834 = bitcast<i32>(bitcast<u32>((((_e3713.member_1 * _e934) + _e3713.member) * 6i)));
if ((_e3754 | _e3761) == 0u) {
} else {
let _e3837 = bitcast<u32>(_e3834);
if (_e3837 < _e269) {
let _e3841 = atomicAdd((&global_8.member[_e3837]), _e3754);
phi_8262_ = _e3841;
} else {
phi_8262_ = 0u;
}
let _e3843 = phi_8262_;
let _e3847 = (_e3761 + select(0u, 1u, ((_e3843 + _e3754) < _e3754)));
if (_e3847 == 0u) {
} else {
let _e3849 = (_e3837 + 1u);
if (_e3849 < _e269) {
let _e3853 = atomicAdd((&global_8.member[_e3849]), _e3847);
}
}
}
if ((_e3788 | _e3795) == 0u) {
} else {
let _e3857 = bitcast<u32>((_e3834 + 2i));
if (_e3857 < _e269) {
let _e3861 = atomicAdd((&global_8.member[_e3857]), _e3788);
phi_8292_ = _e3861;
} else {
phi_8292_ = 0u;
}
let _e3863 = phi_8292_;
let _e3867 = (_e3795 + select(0u, 1u, ((_e3863 + _e3788) < _e3788)));
if (_e3867 == 0u) {
} else {
let _e3869 = (_e3857 + 1u);
if (_e3869 < _e269) {
let _e3873 = atomicAdd((&global_8.member[_e3869]), _e3867);
}
}
}
if ((_e3822 | _e3829) == 0u) {
} else {
let _e3877 = bitcast<u32>((_e3834 + 4i));
if (_e3877 < _e269) {
let _e3881 = atomicAdd((&global_8.member[_e3877]), _e3822);
phi_8322_ = _e3881;
} else {
phi_8322_ = 0u;
}
let _e3883 = phi_8322_;
let _e3887 = (_e3829 + select(0u, 1u, ((_e3883 + _e3822) < _e3822)));
if (_e3887 == 0u) {
} else {
let _e3889 = (_e3877 + 1u);
if (_e3889 < _e269) {
let _e3893 = atomicAdd((&global_8.member[_e3889]), _e3887);
}
}
}
phi_4114_ = (_e2200 + 1i);
} else {
phi_4114_ = i32();
}
let _e3896 = phi_4114_;
continue;
continuing {
phi_4113_ = _e3896;
break if !(_e2203);
}
}
phi_3960_ = (_e2107 + 1i);
} else {
phi_3960_ = i32();
}
let _e3900 = phi_3960_;
continue;
continuing {
phi_3959_ = _e3900;
break if !(_e2108);
}
}
} else {
phi_8367_ = 0i;
loop {
let _e3903 = phi_8367_;
let _e3904 = (_e3903 < 16i);
if _e3904 {
let _e3906 = (_e979 + (_e3903 & 15i));
let _e3908 = (f32(_e3906) + 0.5f);
let _e3910 = ((_e3908 * 1f) - 0.5f);
let _e3914 = (-(((_e415 * _e3910) + _e441)) / _e428);
let _e3921 = bitcast<f32>((bitcast<u32>(((_e465 * _e3910) + ((_e478 * _e3914) + _e491))) & 2147483647u));
let _e3928 = bitcast<f32>((bitcast<u32>(((_e504 * _e3910) + ((_e517 * _e3914) + _e530))) & 2147483647u));
let _e3932 = (((0.5f * (_e3921 + _e3928)) / _e533) + _e716);
let _e3933 = (1f / 1f);
let _e3941 = ((((_e3914 + _e3932) + 0.5f) * _e3933) - 0.5f);
let _e3942 = f32(_e984);
let _e3943 = (0f - 1f);
let _e3945 = select(_e3943, _e3941, (_e3941 > _e3943));
let _e3947 = select(_e3942, _e3945, (_e3945 < _e3942));
let _e3954 = select(0i, select(select(i32(_e3947), i32(-2147483648), (_e3947 < -2147483600f)), 2147483647i, (_e3947 > 2147483500f)), (_e3947 == _e3947));
let _e3959 = (((((_e3914 - _e3932) + 0.5f) * _e3933) - 0.5f) + 1f);
let _e3960 = (_e3942 + 1f);
let _e3962 = select(0f, _e3959, (_e3959 > 0f));
let _e3964 = select(_e3960, _e3962, (_e3962 < _e3960));
let _e3971 = select(0i, select(select(i32(_e3964), i32(-2147483648), (_e3964 < -2147483600f)), 2147483647i, (_e3964 > 2147483500f)), (_e3964 == _e3964));
let _e3982 = ((1e-4f * 1f) * _e533);
let _e3984 = select(_e3928, _e3921, (_e3921 > _e3928));
let _e3986 = select(_e3982, _e3984, (_e3984 > _e3982));
let _e3988 = select(_e3928, _e3921, (_e3921 < _e3928));
let _e3990 = select(_e3982, _e3988, (_e3988 > _e3982));
let _e3992 = (0.5f * (_e3986 + _e3990));
let _e3993 = (0.5f / _e3990);
let _e3994 = (1f / _e3986);
phi_8521_ = 0i;
loop {
let _e3996 = phi_8521_;
let _e3998 = (((_e3971 - select(0i, 1i, (_e3964 < f32(_e3971)))) + (_e3903 >> bitcast<u32>(4u))) + bitcast<i32>(_e3996));
let _e3999 = (_e3998 <= select(-1i, (_e3954 - select(0i, 1i, (_e3947 < f32(_e3954)))), (_e3906 <= _e983)));
if _e3999 {
let _e4001 = (f32(_e3998) + 0.5f);
let _e4005 = ((((_e4001 * 1f) - 0.5f) - _e3914) * _e533);
let _e4006 = (_e533 * 1f);
let _e4008 = (0.5f * _e4006);
let _e4009 = (_e4005 + _e4008);
let _e4010 = -(_e4009);
let _e4013 = (_e3992 - select(_e4010, _e4009, (_e4009 > _e4010)));
let _e4015 = select(0f, _e4013, (_e4013 > 0f));
let _e4017 = select(_e3990, _e4015, (_e4015 < _e3990));
let _e4020 = (_e4013 - _e3990);
let _e4024 = (((_e4017 * (_e4017 * _e3993)) + select(0f, _e4020, (_e4020 > 0f))) * _e3994);
let _e4028 = (_e4005 - _e4008);
let _e4029 = -(_e4028);
let _e4032 = (_e3992 - select(_e4029, _e4028, (_e4028 > _e4029)));
let _e4034 = select(0f, _e4032, (_e4032 > 0f));
let _e4036 = select(_e3990, _e4034, (_e4034 < _e3990));
let _e4039 = (_e4032 - _e3990);
let _e4043 = (((_e4036 * (_e4036 * _e3993)) + select(0f, _e4039, (_e4039 > 0f))) * _e3994);
if _e452 {
phi_8626_ = type_23(_e3998, _e3906);
} else {
phi_8626_ = type_23(_e3906, _e3998);
}
let _e4052 = phi_8626_;
let _e4056 = bitcast<i32>((_e930 * _e933));
local_186 = _e4056;
local_187 = ((_e4052.member_1 * _e934) + _e4052.member);
let _e4059 = local_186;
let _e4060 = local_187;
let _e4061 = (_e4059 + _e4060);
let _e4063 = (bitcast<i32>(_e258) - 1i);
let _e4065 = select(_e4063, _e4061, (_e4061 < _e4063));
let _e4070 = global_5.member[bitcast<u32>(select(0i, _e4065, (_e4065 > 0i)))];
let _e4071 = local_186;
let _e4073 = local_187;
let _e4074 = ((2i * _e4071) + _e4073);
let _e4076 = select(_e4063, _e4074, (_e4074 < _e4063));
let _e4081 = global_5.member[bitcast<u32>(select(0i, _e4076, (_e4076 > 0i)))];
let _e4082 = local_187;
let _e4084 = select(_e4063, _e4082, (_e4082 < _e4063));
let _e4089 = global_5.member[bitcast<u32>(select(0i, _e4084, (_e4084 > 0i)))];
let _e4090 = local_187;
let _e4093 = f32(_e934);
let _e4094 = f32(_e935);
let _e4101 = global_1.member.member_2.member;
let _e4102 = (((((f32(_e4052.member) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e4109 = global_1.member.member_2.member_1;
let _e4110 = ((1f - (((f32(_e4052.member_1) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e4112 = global_1.member.member_3;
let _e4120 = global_1.member.member_4;
let _e4127 = ((_e4112.member * _e4102) + (_e4120.member * _e4110));
let _e4128 = ((_e4112.member_1 * _e4102) + (_e4120.member_1 * _e4110));
let _e4129 = ((_e4112.member_2 * _e4102) + (_e4120.member_2 * _e4110));
let _e4132 = global_1.member.member_2.member_3;
let _e4133 = (_e4132 != 0u);
let _e4135 = global_1.member.member_5;
let _e4142 = select((_e4135.member + _e4127), _e4135.member, _e4133);
let _e4143 = select((_e4135.member_1 + _e4128), _e4135.member_1, _e4133);
let _e4144 = select((_e4135.member_2 + _e4129), _e4135.member_2, _e4133);
let _e4146 = global_1.member.member_6;
let _e4153 = select(_e4146.member, (_e4146.member + _e4127), _e4133);
let _e4154 = select(_e4146.member_1, (_e4146.member_1 + _e4128), _e4133);
let _e4155 = select(_e4146.member_2, (_e4146.member_2 + _e4129), _e4133);
let _e4160 = (((_e4142 * _e4142) + (_e4143 * _e4143)) + (_e4144 * _e4144));
let _e4163 = sqrt(select(0f, _e4160, (_e4160 > 0f)));
let _e4164 = (1f / _e4163);
let _e4165 = (_e4142 * _e4164);
let _e4166 = (_e4143 * _e4164);
let _e4167 = (_e4144 * _e4164);
let _e4168 = (_e574 - _e4153);
let _e4169 = (_e586 - _e4154);
let _e4170 = (_e599 - _e4155);
let _e4175 = (((_e4168 * _e4165) + (_e4169 * _e4166)) + (_e4170 * _e4167));
let _e4180 = (((_e4168 * _e612) + (_e4169 * _e625)) + (_e4170 * _e638));
let _e4185 = (((_e4165 * _e612) + (_e4166 * _e625)) + (_e4167 * _e638));
let _e4188 = ((_e4166 * _e638) - (_e4167 * _e625));
let _e4191 = ((_e4167 * _e612) - (_e4165 * _e638));
let _e4194 = ((_e4165 * _e625) - (_e4166 * _e612));
let _e4199 = (((_e4188 * _e4188) + (_e4191 * _e4191)) + (_e4194 * _e4194));
let _e4202 = (1f / select(1e-9f, _e4199, (_e4199 > 1e-9f)));
let _e4205 = ((_e4175 - (_e4185 * _e4180)) * _e4202);
let _e4208 = (((_e4185 * _e4175) - _e4180) * _e4202);
let _e4214 = -(_e4185);
let _e4217 = global_1.member.member_13.member_2;
let _e4218 = (_e4217 * _e4217);
let _e4222 = ((1f + _e4218) - ((2f * _e4217) * _e4214));
let _e4224 = select(1e-9f, _e4222, (_e4222 > 1e-9f));
let _e4236 = global_1.member.member_13.member_3;
let _e4244 = global_1.member.member_12.member_10;
let _e4247 = global_1.member.member_12.member_4;
let _e4250 = global_1.member.member_12.member_11;
let _e4256 = global_1.member.member.member;
let _e4258 = (_e4208 / _e690);
local_183 = bitcast<i32>((_e4244 + (_e4247 * _e4250)));
local_184 = _e280;
local_185 = bitcast<i32>(_e4256);
let _e4261 = global_1.member.member_13.member_6;
let _e4262 = f32(_e4261);
let _e4264 = select(0f, _e4258, (_e4258 > 0f));
let _e4267 = (select(1f, _e4264, (_e4264 < 1f)) * _e4262);
let _e4268 = (_e4262 - 1f);
let _e4270 = select(0f, _e4268, (_e4268 > 0f));
let _e4272 = select(0f, _e4267, (_e4267 > 0f));
let _e4274 = select(_e4270, _e4272, (_e4272 < _e4270));
let _e4281 = select(0i, select(select(i32(_e4274), i32(-2147483648), (_e4274 < -2147483600f)), 2147483647i, (_e4274 > 2147483500f)), (_e4274 == _e4274));
let _e4285 = (_e4281 - select(0i, 1i, (_e4274 < f32(_e4281))));
if (_e4285 > 0i) {
let _e4288 = local_183;
let _e4289 = local_185;
let _e4292 = local_184;
let _e4293 = ((_e4288 + ((_e4285 - 1i) * _e4289)) + _e4292);
let _e4295 = (bitcast<i32>(_e267) - 1i);
let _e4297 = select(_e4295, _e4293, (_e4293 < _e4295));
let _e4302 = global_7.member[bitcast<u32>(select(0i, _e4297, (_e4297 > 0i)))];
phi_9039_ = _e4302;
} else {
phi_9039_ = 0f;
}
let _e4304 = phi_9039_;
let _e4305 = local_183;
let _e4306 = local_185;
let _e4309 = local_184;
let _e4310 = ((_e4305 + (_e4285 * _e4306)) + _e4309);
let _e4312 = (bitcast<i32>(_e267) - 1i);
let _e4314 = select(_e4312, _e4310, (_e4310 < _e4312));
let _e4319 = global_7.member[bitcast<u32>(select(0i, _e4314, (_e4314 > 0i)))];
let _e4326 = (_e4081 - _e4070);
let _e4329 = ((_e4205 - _e4070) / select(1e-9f, _e4326, (_e4326 > 1e-9f)));
local_180 = 0i;
local_181 = _e4090;
local_182 = _e4056;
let _e4331 = select(0f, _e4329, (_e4329 > 0f));
let _e4334 = (select(1f, _e4331, (_e4331 < 1f)) * _e4262);
let _e4336 = select(0f, _e4334, (_e4334 > 0f));
let _e4338 = select(_e4270, _e4336, (_e4336 < _e4270));
let _e4345 = select(0i, select(select(i32(_e4338), i32(-2147483648), (_e4338 < -2147483600f)), 2147483647i, (_e4338 > 2147483500f)), (_e4338 == _e4338));
let _e4349 = (_e4345 - select(0i, 1i, (_e4338 < f32(_e4345))));
if (_e4349 > 0i) {
let _e4352 = local_180;
let _e4353 = local_182;
let _e4356 = local_181;
let _e4357 = ((_e4352 + ((_e4349 - 1i) * _e4353)) + _e4356);
let _e4359 = select(_e4312, _e4357, (_e4357 < _e4312));
let _e4364 = global_7.member[bitcast<u32>(select(0i, _e4359, (_e4359 > 0i)))];
phi_9166_ = _e4364;
} else {
phi_9166_ = 0f;
}
let _e4366 = phi_9166_;
let _e4367 = local_180;
let _e4368 = local_182;
let _e4371 = local_181;
let _e4372 = ((_e4367 + (_e4349 * _e4368)) + _e4371);
let _e4374 = select(_e4312, _e4372, (_e4372 < _e4312));
let _e4379 = global_7.member[bitcast<u32>(select(0i, _e4374, (_e4374 > 0i)))];
let _e4385 = ((_e4304 + ((_e4319 - _e4304) * (_e4267 - f32(_e4285)))) + (_e4366 + ((_e4379 - _e4366) * (_e4334 - f32(_e4349)))));
let _e4394 = global_1.member.member_13.member_7;
let _e4395 = bitcast<i32>(_e4394);
let _e4398 = global_1.member.member_13.member_8;
let _e4399 = bitcast<i32>(_e4398);
let _e4402 = global_1.member.member_13.member_9;
let _e4403 = bitcast<i32>(_e4402);
let _e4406 = global_1.member.member_13.member_4;
let _e4412 = global_1.member.member_13.member_5;
let _e4416 = f32(_e4395);
let _e4421 = (((((_e4153 + (_e4165 * _e4205)) - _e4406.member) / (_e4412.member - _e4406.member)) * _e4416) - 0.5f);
let _e4422 = (_e4416 - 1f);
let _e4424 = select(0f, _e4421, (_e4421 > 0f));
let _e4426 = select(_e4422, _e4424, (_e4424 < _e4422));
let _e4427 = f32(_e4399);
let _e4432 = (((((_e4154 + (_e4166 * _e4205)) - _e4406.member_1) / (_e4412.member_1 - _e4406.member_1)) * _e4427) - 0.5f);
let _e4433 = (_e4427 - 1f);
let _e4435 = select(0f, _e4432, (_e4432 > 0f));
let _e4437 = select(_e4433, _e4435, (_e4435 < _e4433));
let _e4438 = f32(_e4403);
let _e4443 = (((((_e4155 + (_e4167 * _e4205)) - _e4406.member_2) / (_e4412.member_2 - _e4406.member_2)) * _e4438) - 0.5f);
let _e4444 = (_e4438 - 1f);
let _e4446 = select(0f, _e4443, (_e4443 > 0f));
let _e4448 = select(_e4444, _e4446, (_e4446 < _e4444));
let _e4450 = select(0f, _e4426, (_e4426 > 0f));
let _e4452 = select(1e6f, _e4450, (_e4450 < 1e6f));
let _e4459 = select(0i, select(select(i32(_e4452), i32(-2147483648), (_e4452 < -2147483600f)), 2147483647i, (_e4452 > 2147483500f)), (_e4452 == _e4452));
let _e4463 = (_e4459 - select(0i, 1i, (_e4452 < f32(_e4459))));
let _e4465 = select(0f, _e4437, (_e4437 > 0f));
let _e4467 = select(1e6f, _e4465, (_e4465 < 1e6f));
let _e4474 = select(0i, select(select(i32(_e4467), i32(-2147483648), (_e4467 < -2147483600f)), 2147483647i, (_e4467 > 2147483500f)), (_e4467 == _e4467));
let _e4478 = (_e4474 - select(0i, 1i, (_e4467 < f32(_e4474))));
let _e4480 = select(0f, _e4448, (_e4448 > 0f));
let _e4482 = select(1e6f, _e4480, (_e4480 < 1e6f));
let _e4489 = select(0i, select(select(i32(_e4482), i32(-2147483648), (_e4482 < -2147483600f)), 2147483647i, (_e4482 > 2147483500f)), (_e4482 == _e4482));
let _e4493 = (_e4489 - select(0i, 1i, (_e4482 < f32(_e4489))));
let _e4497 = (_e4437 - f32(_e4478));
let _e4499 = (_e4448 - f32(_e4493));
local_178 = (_e4426 - f32(_e4463));
let _e4500 = (_e4463 + 1i);
let _e4502 = select(_e4500, 0i, (_e4500 < 0i));
if (_e4502 >= _e4395) {
phi_9314_ = (_e4395 - 1i);
} else {
phi_9314_ = _e4502;
}
let _e4506 = phi_9314_;
local_179 = (_e4506 - _e4463);
let _e4508 = (_e4478 + 1i);
let _e4510 = select(_e4508, 0i, (_e4508 < 0i));
if (_e4510 >= _e4399) {
phi_9327_ = (_e4399 - 1i);
} else {
phi_9327_ = _e4510;
}
let _e4514 = phi_9327_;
let _e4516 = ((_e4514 - _e4478) * _e4395);
let _e4517 = (_e4493 + 1i);
let _e4519 = select(_e4517, 0i, (_e4517 < 0i));
if (_e4519 >= _e4403) {
phi_9341_ = (_e4403 - 1i);
} else {
phi_9341_ = _e4519;
}
let _e4523 = phi_9341_;
let _e4529 = global_1.member.member_13.member_10;
let _e4535 = ((bitcast<i32>(_e4529) + (((_e4493 * _e4399) + _e4478) * _e4395)) + _e4463);
let _e4537 = (bitcast<i32>(_e264) - 1i);
let _e4539 = select(_e4537, _e4535, (_e4535 < _e4537));
let _e4544 = global_2.member[bitcast<u32>(select(0i, _e4539, (_e4539 > 0i)))];
let _e4545 = local_178;
let _e4548 = local_179;
let _e4549 = (_e4535 + _e4548);
let _e4551 = select(_e4537, _e4549, (_e4549 < _e4537));
let _e4556 = global_2.member[bitcast<u32>(select(0i, _e4551, (_e4551 > 0i)))];
let _e4557 = local_178;
let _e4560 = (1f - _e4497);
let _e4562 = (_e4535 + _e4516);
let _e4564 = select(_e4537, _e4562, (_e4562 < _e4537));
let _e4569 = global_2.member[bitcast<u32>(select(0i, _e4564, (_e4564 > 0i)))];
let _e4570 = local_178;
let _e4573 = local_179;
let _e4574 = (_e4562 + _e4573);
let _e4576 = select(_e4537, _e4574, (_e4574 < _e4537));
let _e4581 = global_2.member[bitcast<u32>(select(0i, _e4576, (_e4576 > 0i)))];
let _e4582 = local_178;
let _e4587 = (_e4535 + (((_e4523 - _e4493) * _e4395) * _e4399));
let _e4589 = select(_e4537, _e4587, (_e4587 < _e4537));
let _e4594 = global_2.member[bitcast<u32>(select(0i, _e4589, (_e4589 > 0i)))];
let _e4595 = local_178;
let _e4598 = local_179;
let _e4599 = (_e4587 + _e4598);
let _e4601 = select(_e4537, _e4599, (_e4599 < _e4537));
let _e4606 = global_2.member[bitcast<u32>(select(0i, _e4601, (_e4601 > 0i)))];
let _e4607 = local_178;
let _e4611 = (_e4587 + _e4516);
let _e4613 = select(_e4537, _e4611, (_e4611 < _e4537));
let _e4618 = global_2.member[bitcast<u32>(select(0i, _e4613, (_e4613 > 0i)))];
let _e4619 = local_178;
let _e4622 = local_179;
let _e4623 = (_e4611 + _e4622);
let _e4625 = select(_e4537, _e4623, (_e4623 < _e4537));
let _e4630 = global_2.member[bitcast<u32>(select(0i, _e4625, (_e4625 > 0i)))];
let _e4631 = local_178;
let _e4640 = ((_e4163 * (select(((1f - _e4218) / (_e4224 * sqrt(select(0f, _e4224, (_e4224 > 0f))))), (0.75f * (1f + (_e4214 * _e4214))), (_e4236 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e4544 * (1f - _e4545)) + (_e4556 * _e4557)) * _e4560) + (((_e4569 * (1f - _e4570)) + (_e4581 * _e4582)) * _e4497)) * (1f - _e4499)) + (((((_e4594 * (1f - _e4595)) + (_e4606 * _e4607)) * _e4560) + (((_e4618 * (1f - _e4619)) + (_e4630 * _e4631)) * _e4497)) * _e4499)));
let _e4643 = global_1.member.member_13.member_1;
let _e4652 = global_1.member.member_13.member;
let _e4657 = -((_e4652.member * _e4385));
let _e4659 = select(-87f, _e4657, (_e4657 > -87f));
let _e4661 = select(88f, _e4659, (_e4659 < 88f));
let _e4663 = ((_e4661 * 1.442695f) + 0.5f);
let _e4665 = select(-127f, _e4663, (_e4663 > -127f));
let _e4667 = select(128f, _e4665, (_e4665 < 128f));
let _e4674 = select(0i, select(select(i32(_e4667), i32(-2147483648), (_e4667 < -2147483600f)), 2147483647i, (_e4667 > 2147483500f)), (_e4667 == _e4667));
let _e4678 = (_e4674 - select(0i, 1i, (_e4667 < f32(_e4674))));
let _e4679 = f32(_e4678);
let _e4683 = ((_e4661 - (_e4679 * 0.6933594f)) - (_e4679 * -2.1219444e-4f));
let _e4705 = -((_e4652.member_1 * _e4385));
let _e4707 = select(-87f, _e4705, (_e4705 > -87f));
let _e4709 = select(88f, _e4707, (_e4707 < 88f));
let _e4711 = ((_e4709 * 1.442695f) + 0.5f);
let _e4713 = select(-127f, _e4711, (_e4711 > -127f));
let _e4715 = select(128f, _e4713, (_e4713 < 128f));
let _e4722 = select(0i, select(select(i32(_e4715), i32(-2147483648), (_e4715 < -2147483600f)), 2147483647i, (_e4715 > 2147483500f)), (_e4715 == _e4715));
let _e4726 = (_e4722 - select(0i, 1i, (_e4715 < f32(_e4722))));
let _e4727 = f32(_e4726);
let _e4731 = ((_e4709 - (_e4727 * 0.6933594f)) - (_e4727 * -2.1219444e-4f));
let _e4753 = -((_e4652.member_2 * _e4385));
let _e4755 = select(-87f, _e4753, (_e4753 > -87f));
let _e4757 = select(88f, _e4755, (_e4755 < 88f));
let _e4759 = ((_e4757 * 1.442695f) + 0.5f);
let _e4761 = select(-127f, _e4759, (_e4759 > -127f));
let _e4763 = select(128f, _e4761, (_e4761 < 128f));
let _e4770 = select(0i, select(select(i32(_e4763), i32(-2147483648), (_e4763 < -2147483600f)), 2147483647i, (_e4763 > 2147483500f)), (_e4763 == _e4763));
let _e4774 = (_e4770 - select(0i, 1i, (_e4763 < f32(_e4770))));
let _e4775 = f32(_e4774);
let _e4779 = ((_e4757 - (_e4775 * 0.6933594f)) - (_e4775 * -2.1219444e-4f));
let _e4806 = select(0f, _e4205, (((_e4208 >= 0f) && (_e4208 < _e690)) && (_e4205 > 0f)));
let _e4807 = (_e765 & 31u);
let _e4809 = (1u << bitcast<u32>(_e4807));
let _e4818 = bitcast<i32>((((_e930 + _e4809) - 1u) >> bitcast<u32>(_e4807)));
let _e4819 = bitcast<i32>((((_e933 + _e4809) - 1u) >> bitcast<u32>(_e4807)));
if _e452 {
phi_9800_ = type_23(_e4819, _e4818);
} else {
phi_9800_ = type_23(_e4818, _e4819);
}
let _e4823 = phi_9800_;
let _e4828 = f32((1i << bitcast<u32>(_e4807)));
let _e4829 = (1f / _e4828);
let _e4831 = ((_e3908 * _e4829) - 0.5f);
let _e4833 = ((_e4001 * _e4829) - 0.5f);
let _e4835 = select(-1f, _e4831, (_e4831 > -1f));
let _e4837 = select(1e6f, _e4835, (_e4835 < 1e6f));
let _e4844 = select(0i, select(select(i32(_e4837), i32(-2147483648), (_e4837 < -2147483600f)), 2147483647i, (_e4837 > 2147483500f)), (_e4837 == _e4837));
let _e4848 = (_e4844 - select(0i, 1i, (_e4837 < f32(_e4844))));
let _e4850 = select(-1f, _e4833, (_e4833 > -1f));
let _e4852 = select(1e6f, _e4850, (_e4850 < 1e6f));
let _e4859 = select(0i, select(select(i32(_e4852), i32(-2147483648), (_e4852 < -2147483600f)), 2147483647i, (_e4852 > 2147483500f)), (_e4852 == _e4852));
let _e4863 = (_e4859 - select(0i, 1i, (_e4852 < f32(_e4859))));
let _e4865 = (_e4831 - f32(_e4848));
let _e4867 = (_e4833 - f32(_e4863));
let _e4868 = (1f - _e4865);
let _e4869 = (1f - _e4867);
let _e4872 = select(_e4848, 0i, (_e4848 < 0i));
let _e4873 = (_e4872 >= _e4823.member);
if _e4873 {
phi_9878_ = (_e4823.member - 1i);
} else {
phi_9878_ = _e4872;
}
let _e4876 = phi_9878_;
let _e4878 = select(_e4863, 0i, (_e4863 < 0i));
let _e4879 = (_e4878 >= _e4823.member_1);
if _e4879 {
phi_9889_ = (_e4823.member_1 - 1i);
} else {
phi_9889_ = _e4878;
}
let _e4882 = phi_9889_;
let _e4886 = (((f32(_e4876) + 0.5f) * _e4828) - 0.5f);
let _e4890 = (((f32(_e4882) + 0.5f) * _e4828) - 0.5f);
if _e452 {
phi_9917_ = type_23(_e4882, _e4876);
} else {
phi_9917_ = type_23(_e4876, _e4882);
}
let _e4896 = phi_9917_;
let _e4902 = bitcast<i32>(((_e930 + 1u) >> bitcast<u32>(1u)));
let _e4905 = global_1.member.member_18.member_6;
let _e4908 = global_1.member.member_18.member_7;
let _e4911 = global_1.member.member_18.member_8;
if _e985 {
phi_9968_ = 0u;
} else {
if (_e765 == 1u) {
phi_9967_ = 0u;
} else {
if (_e765 == 2u) {
phi_9966_ = _e4905;
} else {
phi_9966_ = select(_e4911, _e4908, (_e765 == 3u));
}
let _e4917 = phi_9966_;
phi_9967_ = _e4917;
}
let _e4919 = phi_9967_;
phi_9968_ = _e4919;
}
let _e4921 = phi_9968_;
local_176 = (((bitcast<i32>(_e4921) + _e4896.member_1) * _e4902) + _e4896.member);
let _e4926 = local_176;
let _e4928 = (bitcast<i32>(_e261) - 1i);
let _e4930 = select(_e4928, _e4926, (_e4926 < _e4928));
let _e4935 = global_6.member[bitcast<u32>(select(0i, _e4930, (_e4930 > 0i)))];
let _e4940 = (((((select(_e4886, _e4890, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e4945 = ((1f - (((select(_e4890, _e4886, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e4952 = ((_e4112.member * _e4940) + (_e4120.member * _e4945));
let _e4953 = ((_e4112.member_1 * _e4940) + (_e4120.member_1 * _e4945));
let _e4954 = ((_e4112.member_2 * _e4940) + (_e4120.member_2 * _e4945));
let _e4958 = select((_e4135.member + _e4952), _e4135.member, _e4133);
let _e4959 = select((_e4135.member_1 + _e4953), _e4135.member_1, _e4133);
let _e4960 = select((_e4135.member_2 + _e4954), _e4135.member_2, _e4133);
let _e4971 = (((_e4958 * _e4958) + (_e4959 * _e4959)) + (_e4960 * _e4960));
let _e4975 = (1f / sqrt(select(0f, _e4971, (_e4971 > 0f))));
let _e4976 = (_e4958 * _e4975);
let _e4977 = (_e4959 * _e4975);
let _e4978 = (_e4960 * _e4975);
let _e4979 = (_e574 - select(_e4146.member, (_e4146.member + _e4952), _e4133));
let _e4980 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e4953), _e4133));
let _e4981 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e4954), _e4133));
let _e4986 = (((_e4979 * _e4976) + (_e4980 * _e4977)) + (_e4981 * _e4978));
let _e4991 = (((_e4979 * _e612) + (_e4980 * _e625)) + (_e4981 * _e638));
let _e4996 = (((_e4976 * _e612) + (_e4977 * _e625)) + (_e4978 * _e638));
let _e4999 = ((_e4977 * _e638) - (_e4978 * _e625));
let _e5002 = ((_e4978 * _e612) - (_e4976 * _e638));
let _e5005 = ((_e4976 * _e625) - (_e4977 * _e612));
let _e5010 = (((_e4999 * _e4999) + (_e5002 * _e5002)) + (_e5005 * _e5005));
let _e5013 = (1f / select(1e-9f, _e5010, (_e5010 > 1e-9f)));
let _e5016 = ((_e4986 - (_e4996 * _e4991)) * _e5013);
let _e5019 = (((_e4996 * _e4986) - _e4991) * _e5013);
let _e5025 = select(0f, _e5016, (((_e5019 >= 0f) && (_e5019 < _e690)) && (_e5016 > 0f)));
let _e5027 = (_e4876 << bitcast<u32>(_e4807));
let _e5039 = (_e4848 + 1i);
let _e5042 = select(_e5039, 0i, (_e5039 < 0i));
let _e5043 = (_e5042 >= _e4823.member);
if _e5043 {
phi_10515_ = (_e4823.member - 1i);
} else {
phi_10515_ = _e5042;
}
let _e5046 = phi_10515_;
if _e4879 {
phi_10526_ = (_e4823.member_1 - 1i);
} else {
phi_10526_ = _e4878;
}
let _e5049 = phi_10526_;
let _e5053 = (((f32(_e5046) + 0.5f) * _e4828) - 0.5f);
let _e5057 = (((f32(_e5049) + 0.5f) * _e4828) - 0.5f);
if _e452 {
phi_10554_ = type_23(_e5049, _e5046);
} else {
phi_10554_ = type_23(_e5046, _e5049);
}
let _e5063 = phi_10554_;
if _e985 {
phi_10605_ = 0u;
} else {
if (_e765 == 1u) {
phi_10604_ = 0u;
} else {
if (_e765 == 2u) {
phi_10603_ = _e4905;
} else {
phi_10603_ = select(_e4911, _e4908, (_e765 == 3u));
}
let _e5071 = phi_10603_;
phi_10604_ = _e5071;
}
let _e5073 = phi_10604_;
phi_10605_ = _e5073;
}
let _e5075 = phi_10605_;
local_174 = (((bitcast<i32>(_e5075) + _e5063.member_1) * _e4902) + _e5063.member);
let _e5080 = local_174;
let _e5082 = select(_e4928, _e5080, (_e5080 < _e4928));
let _e5087 = global_6.member[bitcast<u32>(select(0i, _e5082, (_e5082 > 0i)))];
let _e5092 = (((((select(_e5053, _e5057, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5097 = ((1f - (((select(_e5057, _e5053, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5104 = ((_e4112.member * _e5092) + (_e4120.member * _e5097));
let _e5105 = ((_e4112.member_1 * _e5092) + (_e4120.member_1 * _e5097));
let _e5106 = ((_e4112.member_2 * _e5092) + (_e4120.member_2 * _e5097));
let _e5110 = select((_e4135.member + _e5104), _e4135.member, _e4133);
let _e5111 = select((_e4135.member_1 + _e5105), _e4135.member_1, _e4133);
let _e5112 = select((_e4135.member_2 + _e5106), _e4135.member_2, _e4133);
let _e5123 = (((_e5110 * _e5110) + (_e5111 * _e5111)) + (_e5112 * _e5112));
let _e5127 = (1f / sqrt(select(0f, _e5123, (_e5123 > 0f))));
let _e5128 = (_e5110 * _e5127);
let _e5129 = (_e5111 * _e5127);
let _e5130 = (_e5112 * _e5127);
let _e5131 = (_e574 - select(_e4146.member, (_e4146.member + _e5104), _e4133));
let _e5132 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5105), _e4133));
let _e5133 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5106), _e4133));
let _e5138 = (((_e5131 * _e5128) + (_e5132 * _e5129)) + (_e5133 * _e5130));
let _e5143 = (((_e5131 * _e612) + (_e5132 * _e625)) + (_e5133 * _e638));
let _e5148 = (((_e5128 * _e612) + (_e5129 * _e625)) + (_e5130 * _e638));
let _e5151 = ((_e5129 * _e638) - (_e5130 * _e625));
let _e5154 = ((_e5130 * _e612) - (_e5128 * _e638));
let _e5157 = ((_e5128 * _e625) - (_e5129 * _e612));
let _e5162 = (((_e5151 * _e5151) + (_e5154 * _e5154)) + (_e5157 * _e5157));
let _e5165 = (1f / select(1e-9f, _e5162, (_e5162 > 1e-9f)));
let _e5168 = ((_e5138 - (_e5148 * _e5143)) * _e5165);
let _e5171 = (((_e5148 * _e5138) - _e5143) * _e5165);
let _e5177 = select(0f, _e5168, (((_e5171 >= 0f) && (_e5171 < _e690)) && (_e5168 > 0f)));
let _e5179 = (_e5046 << bitcast<u32>(_e4807));
let _e5191 = (_e4863 + 1i);
if _e4873 {
phi_11152_ = (_e4823.member - 1i);
} else {
phi_11152_ = _e4872;
}
let _e5195 = phi_11152_;
let _e5197 = select(_e5191, 0i, (_e5191 < 0i));
let _e5198 = (_e5197 >= _e4823.member_1);
if _e5198 {
phi_11163_ = (_e4823.member_1 - 1i);
} else {
phi_11163_ = _e5197;
}
let _e5201 = phi_11163_;
let _e5205 = (((f32(_e5195) + 0.5f) * _e4828) - 0.5f);
let _e5209 = (((f32(_e5201) + 0.5f) * _e4828) - 0.5f);
if _e452 {
phi_11191_ = type_23(_e5201, _e5195);
} else {
phi_11191_ = type_23(_e5195, _e5201);
}
let _e5215 = phi_11191_;
if _e985 {
phi_11242_ = 0u;
} else {
if (_e765 == 1u) {
phi_11241_ = 0u;
} else {
if (_e765 == 2u) {
phi_11240_ = _e4905;
} else {
phi_11240_ = select(_e4911, _e4908, (_e765 == 3u));
}
let _e5223 = phi_11240_;
phi_11241_ = _e5223;
}
let _e5225 = phi_11241_;
phi_11242_ = _e5225;
}
let _e5227 = phi_11242_;
local_172 = (((bitcast<i32>(_e5227) + _e5215.member_1) * _e4902) + _e5215.member);
let _e5232 = local_172;
let _e5234 = select(_e4928, _e5232, (_e5232 < _e4928));
let _e5239 = global_6.member[bitcast<u32>(select(0i, _e5234, (_e5234 > 0i)))];
let _e5244 = (((((select(_e5205, _e5209, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5249 = ((1f - (((select(_e5209, _e5205, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5256 = ((_e4112.member * _e5244) + (_e4120.member * _e5249));
let _e5257 = ((_e4112.member_1 * _e5244) + (_e4120.member_1 * _e5249));
let _e5258 = ((_e4112.member_2 * _e5244) + (_e4120.member_2 * _e5249));
let _e5262 = select((_e4135.member + _e5256), _e4135.member, _e4133);
let _e5263 = select((_e4135.member_1 + _e5257), _e4135.member_1, _e4133);
let _e5264 = select((_e4135.member_2 + _e5258), _e4135.member_2, _e4133);
let _e5275 = (((_e5262 * _e5262) + (_e5263 * _e5263)) + (_e5264 * _e5264));
let _e5279 = (1f / sqrt(select(0f, _e5275, (_e5275 > 0f))));
let _e5280 = (_e5262 * _e5279);
let _e5281 = (_e5263 * _e5279);
let _e5282 = (_e5264 * _e5279);
let _e5283 = (_e574 - select(_e4146.member, (_e4146.member + _e5256), _e4133));
let _e5284 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5257), _e4133));
let _e5285 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5258), _e4133));
let _e5290 = (((_e5283 * _e5280) + (_e5284 * _e5281)) + (_e5285 * _e5282));
let _e5295 = (((_e5283 * _e612) + (_e5284 * _e625)) + (_e5285 * _e638));
let _e5300 = (((_e5280 * _e612) + (_e5281 * _e625)) + (_e5282 * _e638));
let _e5303 = ((_e5281 * _e638) - (_e5282 * _e625));
let _e5306 = ((_e5282 * _e612) - (_e5280 * _e638));
let _e5309 = ((_e5280 * _e625) - (_e5281 * _e612));
let _e5314 = (((_e5303 * _e5303) + (_e5306 * _e5306)) + (_e5309 * _e5309));
let _e5317 = (1f / select(1e-9f, _e5314, (_e5314 > 1e-9f)));
let _e5320 = ((_e5290 - (_e5300 * _e5295)) * _e5317);
let _e5323 = (((_e5300 * _e5290) - _e5295) * _e5317);
let _e5329 = select(0f, _e5320, (((_e5323 >= 0f) && (_e5323 < _e690)) && (_e5320 > 0f)));
let _e5331 = (_e5195 << bitcast<u32>(_e4807));
if _e5043 {
phi_11789_ = (_e4823.member - 1i);
} else {
phi_11789_ = _e5042;
}
let _e5346 = phi_11789_;
if _e5198 {
phi_11800_ = (_e4823.member_1 - 1i);
} else {
phi_11800_ = _e5197;
}
let _e5349 = phi_11800_;
let _e5353 = (((f32(_e5346) + 0.5f) * _e4828) - 0.5f);
let _e5357 = (((f32(_e5349) + 0.5f) * _e4828) - 0.5f);
if _e452 {
phi_11828_ = type_23(_e5349, _e5346);
} else {
phi_11828_ = type_23(_e5346, _e5349);
}
let _e5363 = phi_11828_;
if _e985 {
phi_11879_ = 0u;
} else {
if (_e765 == 1u) {
phi_11878_ = 0u;
} else {
if (_e765 == 2u) {
phi_11877_ = _e4905;
} else {
phi_11877_ = select(_e4911, _e4908, (_e765 == 3u));
}
let _e5371 = phi_11877_;
phi_11878_ = _e5371;
}
let _e5373 = phi_11878_;
phi_11879_ = _e5373;
}
let _e5375 = phi_11879_;
local_170 = (((bitcast<i32>(_e5375) + _e5363.member_1) * _e4902) + _e5363.member);
let _e5380 = local_170;
let _e5382 = select(_e4928, _e5380, (_e5380 < _e4928));
let _e5387 = global_6.member[bitcast<u32>(select(0i, _e5382, (_e5382 > 0i)))];
let _e5392 = (((((select(_e5353, _e5357, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5397 = ((1f - (((select(_e5357, _e5353, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5404 = ((_e4112.member * _e5392) + (_e4120.member * _e5397));
let _e5405 = ((_e4112.member_1 * _e5392) + (_e4120.member_1 * _e5397));
let _e5406 = ((_e4112.member_2 * _e5392) + (_e4120.member_2 * _e5397));
let _e5410 = select((_e4135.member + _e5404), _e4135.member, _e4133);
let _e5411 = select((_e4135.member_1 + _e5405), _e4135.member_1, _e4133);
let _e5412 = select((_e4135.member_2 + _e5406), _e4135.member_2, _e4133);
let _e5423 = (((_e5410 * _e5410) + (_e5411 * _e5411)) + (_e5412 * _e5412));
let _e5427 = (1f / sqrt(select(0f, _e5423, (_e5423 > 0f))));
let _e5428 = (_e5410 * _e5427);
let _e5429 = (_e5411 * _e5427);
let _e5430 = (_e5412 * _e5427);
let _e5431 = (_e574 - select(_e4146.member, (_e4146.member + _e5404), _e4133));
let _e5432 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5405), _e4133));
let _e5433 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5406), _e4133));
let _e5438 = (((_e5431 * _e5428) + (_e5432 * _e5429)) + (_e5433 * _e5430));
let _e5443 = (((_e5431 * _e612) + (_e5432 * _e625)) + (_e5433 * _e638));
let _e5448 = (((_e5428 * _e612) + (_e5429 * _e625)) + (_e5430 * _e638));
let _e5451 = ((_e5429 * _e638) - (_e5430 * _e625));
let _e5454 = ((_e5430 * _e612) - (_e5428 * _e638));
let _e5457 = ((_e5428 * _e625) - (_e5429 * _e612));
let _e5462 = (((_e5451 * _e5451) + (_e5454 * _e5454)) + (_e5457 * _e5457));
let _e5465 = (1f / select(1e-9f, _e5462, (_e5462 > 1e-9f)));
let _e5468 = ((_e5438 - (_e5448 * _e5443)) * _e5465);
let _e5471 = (((_e5448 * _e5438) - _e5443) * _e5465);
let _e5477 = select(0f, _e5468, (((_e5471 >= 0f) && (_e5471 < _e690)) && (_e5468 > 0f)));
let _e5479 = (_e5346 << bitcast<u32>(_e4807));
let _e5491 = select(((((1f - select(0f, (_e4868 * _e4869), (((select(select(_e765, _e926, (_e5027 >= _e691)), _e846, (_e5027 < _e297)) == _e765) && (_e5025 > 0f)) && (_e5025 < _e4935)))) - select(0f, (_e4865 * _e4869), (((select(select(_e765, _e926, (_e5179 >= _e691)), _e846, (_e5179 < _e297)) == _e765) && (_e5177 > 0f)) && (_e5177 < _e5087)))) - select(0f, (_e4868 * _e4867), (((select(select(_e765, _e926, (_e5331 >= _e691)), _e846, (_e5331 < _e297)) == _e765) && (_e5329 > 0f)) && (_e5329 < _e5239)))) - select(0f, (_e4865 * _e4867), (((select(select(_e765, _e926, (_e5479 >= _e691)), _e846, (_e5479 < _e297)) == _e765) && (_e5477 > 0f)) && (_e5477 < _e5387)))), 1f, _e985);
let _e5492 = (_e987 & 31u);
let _e5494 = (1u << bitcast<u32>(_e5492));
let _e5503 = bitcast<i32>((((_e930 + _e5494) - 1u) >> bitcast<u32>(_e5492)));
let _e5504 = bitcast<i32>((((_e933 + _e5494) - 1u) >> bitcast<u32>(_e5492)));
if _e452 {
phi_12444_ = type_23(_e5504, _e5503);
} else {
phi_12444_ = type_23(_e5503, _e5504);
}
let _e5508 = phi_12444_;
let _e5513 = f32((1i << bitcast<u32>(_e5492)));
let _e5514 = (1f / _e5513);
let _e5516 = ((_e3908 * _e5514) - 0.5f);
let _e5518 = ((_e4001 * _e5514) - 0.5f);
let _e5520 = select(-1f, _e5516, (_e5516 > -1f));
let _e5522 = select(1e6f, _e5520, (_e5520 < 1e6f));
let _e5529 = select(0i, select(select(i32(_e5522), i32(-2147483648), (_e5522 < -2147483600f)), 2147483647i, (_e5522 > 2147483500f)), (_e5522 == _e5522));
let _e5533 = (_e5529 - select(0i, 1i, (_e5522 < f32(_e5529))));
let _e5535 = select(-1f, _e5518, (_e5518 > -1f));
let _e5537 = select(1e6f, _e5535, (_e5535 < 1e6f));
let _e5544 = select(0i, select(select(i32(_e5537), i32(-2147483648), (_e5537 < -2147483600f)), 2147483647i, (_e5537 > 2147483500f)), (_e5537 == _e5537));
let _e5548 = (_e5544 - select(0i, 1i, (_e5537 < f32(_e5544))));
let _e5550 = (_e5516 - f32(_e5533));
let _e5552 = (_e5518 - f32(_e5548));
let _e5553 = (1f - _e5550);
let _e5554 = (1f - _e5552);
let _e5557 = select(_e5533, 0i, (_e5533 < 0i));
let _e5558 = (_e5557 >= _e5508.member);
if _e5558 {
phi_12522_ = (_e5508.member - 1i);
} else {
phi_12522_ = _e5557;
}
let _e5561 = phi_12522_;
let _e5563 = select(_e5548, 0i, (_e5548 < 0i));
let _e5564 = (_e5563 >= _e5508.member_1);
if _e5564 {
phi_12533_ = (_e5508.member_1 - 1i);
} else {
phi_12533_ = _e5563;
}
let _e5567 = phi_12533_;
let _e5571 = (((f32(_e5561) + 0.5f) * _e5513) - 0.5f);
let _e5575 = (((f32(_e5567) + 0.5f) * _e5513) - 0.5f);
if _e452 {
phi_12561_ = type_23(_e5567, _e5561);
} else {
phi_12561_ = type_23(_e5561, _e5567);
}
let _e5581 = phi_12561_;
let _e5584 = (_e987 == 0u);
if _e5584 {
phi_12612_ = 0u;
} else {
if (_e987 == 1u) {
phi_12611_ = 0u;
} else {
if (_e987 == 2u) {
phi_12610_ = _e4905;
} else {
phi_12610_ = select(_e4911, _e4908, (_e987 == 3u));
}
let _e5590 = phi_12610_;
phi_12611_ = _e5590;
}
let _e5592 = phi_12611_;
phi_12612_ = _e5592;
}
let _e5594 = phi_12612_;
local_168 = (((bitcast<i32>(_e5594) + _e5581.member_1) * _e4902) + _e5581.member);
let _e5599 = local_168;
let _e5601 = select(_e4928, _e5599, (_e5599 < _e4928));
let _e5606 = global_6.member[bitcast<u32>(select(0i, _e5601, (_e5601 > 0i)))];
let _e5611 = (((((select(_e5571, _e5575, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5616 = ((1f - (((select(_e5575, _e5571, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5623 = ((_e4112.member * _e5611) + (_e4120.member * _e5616));
let _e5624 = ((_e4112.member_1 * _e5611) + (_e4120.member_1 * _e5616));
let _e5625 = ((_e4112.member_2 * _e5611) + (_e4120.member_2 * _e5616));
let _e5629 = select((_e4135.member + _e5623), _e4135.member, _e4133);
let _e5630 = select((_e4135.member_1 + _e5624), _e4135.member_1, _e4133);
let _e5631 = select((_e4135.member_2 + _e5625), _e4135.member_2, _e4133);
let _e5642 = (((_e5629 * _e5629) + (_e5630 * _e5630)) + (_e5631 * _e5631));
let _e5646 = (1f / sqrt(select(0f, _e5642, (_e5642 > 0f))));
let _e5647 = (_e5629 * _e5646);
let _e5648 = (_e5630 * _e5646);
let _e5649 = (_e5631 * _e5646);
let _e5650 = (_e574 - select(_e4146.member, (_e4146.member + _e5623), _e4133));
let _e5651 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5624), _e4133));
let _e5652 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5625), _e4133));
let _e5657 = (((_e5650 * _e5647) + (_e5651 * _e5648)) + (_e5652 * _e5649));
let _e5662 = (((_e5650 * _e612) + (_e5651 * _e625)) + (_e5652 * _e638));
let _e5667 = (((_e5647 * _e612) + (_e5648 * _e625)) + (_e5649 * _e638));
let _e5670 = ((_e5648 * _e638) - (_e5649 * _e625));
let _e5673 = ((_e5649 * _e612) - (_e5647 * _e638));
let _e5676 = ((_e5647 * _e625) - (_e5648 * _e612));
let _e5681 = (((_e5670 * _e5670) + (_e5673 * _e5673)) + (_e5676 * _e5676));
let _e5684 = (1f / select(1e-9f, _e5681, (_e5681 > 1e-9f)));
let _e5687 = ((_e5657 - (_e5667 * _e5662)) * _e5684);
let _e5690 = (((_e5667 * _e5657) - _e5662) * _e5684);
let _e5696 = select(0f, _e5687, (((_e5690 >= 0f) && (_e5690 < _e690)) && (_e5687 > 0f)));
let _e5698 = (_e5561 << bitcast<u32>(_e5492));
let _e5710 = (_e5533 + 1i);
let _e5713 = select(_e5710, 0i, (_e5710 < 0i));
let _e5714 = (_e5713 >= _e5508.member);
if _e5714 {
phi_13159_ = (_e5508.member - 1i);
} else {
phi_13159_ = _e5713;
}
let _e5717 = phi_13159_;
if _e5564 {
phi_13170_ = (_e5508.member_1 - 1i);
} else {
phi_13170_ = _e5563;
}
let _e5720 = phi_13170_;
let _e5724 = (((f32(_e5717) + 0.5f) * _e5513) - 0.5f);
let _e5728 = (((f32(_e5720) + 0.5f) * _e5513) - 0.5f);
if _e452 {
phi_13198_ = type_23(_e5720, _e5717);
} else {
phi_13198_ = type_23(_e5717, _e5720);
}
let _e5734 = phi_13198_;
if _e5584 {
phi_13249_ = 0u;
} else {
if (_e987 == 1u) {
phi_13248_ = 0u;
} else {
if (_e987 == 2u) {
phi_13247_ = _e4905;
} else {
phi_13247_ = select(_e4911, _e4908, (_e987 == 3u));
}
let _e5742 = phi_13247_;
phi_13248_ = _e5742;
}
let _e5744 = phi_13248_;
phi_13249_ = _e5744;
}
let _e5746 = phi_13249_;
local_166 = (((bitcast<i32>(_e5746) + _e5734.member_1) * _e4902) + _e5734.member);
let _e5751 = local_166;
let _e5753 = select(_e4928, _e5751, (_e5751 < _e4928));
let _e5758 = global_6.member[bitcast<u32>(select(0i, _e5753, (_e5753 > 0i)))];
let _e5763 = (((((select(_e5724, _e5728, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5768 = ((1f - (((select(_e5728, _e5724, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5775 = ((_e4112.member * _e5763) + (_e4120.member * _e5768));
let _e5776 = ((_e4112.member_1 * _e5763) + (_e4120.member_1 * _e5768));
let _e5777 = ((_e4112.member_2 * _e5763) + (_e4120.member_2 * _e5768));
let _e5781 = select((_e4135.member + _e5775), _e4135.member, _e4133);
let _e5782 = select((_e4135.member_1 + _e5776), _e4135.member_1, _e4133);
let _e5783 = select((_e4135.member_2 + _e5777), _e4135.member_2, _e4133);
let _e5794 = (((_e5781 * _e5781) + (_e5782 * _e5782)) + (_e5783 * _e5783));
let _e5798 = (1f / sqrt(select(0f, _e5794, (_e5794 > 0f))));
let _e5799 = (_e5781 * _e5798);
let _e5800 = (_e5782 * _e5798);
let _e5801 = (_e5783 * _e5798);
let _e5802 = (_e574 - select(_e4146.member, (_e4146.member + _e5775), _e4133));
let _e5803 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5776), _e4133));
let _e5804 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5777), _e4133));
let _e5809 = (((_e5802 * _e5799) + (_e5803 * _e5800)) + (_e5804 * _e5801));
let _e5814 = (((_e5802 * _e612) + (_e5803 * _e625)) + (_e5804 * _e638));
let _e5819 = (((_e5799 * _e612) + (_e5800 * _e625)) + (_e5801 * _e638));
let _e5822 = ((_e5800 * _e638) - (_e5801 * _e625));
let _e5825 = ((_e5801 * _e612) - (_e5799 * _e638));
let _e5828 = ((_e5799 * _e625) - (_e5800 * _e612));
let _e5833 = (((_e5822 * _e5822) + (_e5825 * _e5825)) + (_e5828 * _e5828));
let _e5836 = (1f / select(1e-9f, _e5833, (_e5833 > 1e-9f)));
let _e5839 = ((_e5809 - (_e5819 * _e5814)) * _e5836);
let _e5842 = (((_e5819 * _e5809) - _e5814) * _e5836);
let _e5848 = select(0f, _e5839, (((_e5842 >= 0f) && (_e5842 < _e690)) && (_e5839 > 0f)));
let _e5850 = (_e5717 << bitcast<u32>(_e5492));
let _e5862 = (_e5548 + 1i);
if _e5558 {
phi_13796_ = (_e5508.member - 1i);
} else {
phi_13796_ = _e5557;
}
let _e5866 = phi_13796_;
let _e5868 = select(_e5862, 0i, (_e5862 < 0i));
let _e5869 = (_e5868 >= _e5508.member_1);
if _e5869 {
phi_13807_ = (_e5508.member_1 - 1i);
} else {
phi_13807_ = _e5868;
}
let _e5872 = phi_13807_;
let _e5876 = (((f32(_e5866) + 0.5f) * _e5513) - 0.5f);
let _e5880 = (((f32(_e5872) + 0.5f) * _e5513) - 0.5f);
if _e452 {
phi_13835_ = type_23(_e5872, _e5866);
} else {
phi_13835_ = type_23(_e5866, _e5872);
}
let _e5886 = phi_13835_;
if _e5584 {
phi_13886_ = 0u;
} else {
if (_e987 == 1u) {
phi_13885_ = 0u;
} else {
if (_e987 == 2u) {
phi_13884_ = _e4905;
} else {
phi_13884_ = select(_e4911, _e4908, (_e987 == 3u));
}
let _e5894 = phi_13884_;
phi_13885_ = _e5894;
}
let _e5896 = phi_13885_;
phi_13886_ = _e5896;
}
let _e5898 = phi_13886_;
local_164 = (((bitcast<i32>(_e5898) + _e5886.member_1) * _e4902) + _e5886.member);
let _e5903 = local_164;
let _e5905 = select(_e4928, _e5903, (_e5903 < _e4928));
let _e5910 = global_6.member[bitcast<u32>(select(0i, _e5905, (_e5905 > 0i)))];
let _e5915 = (((((select(_e5876, _e5880, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e5920 = ((1f - (((select(_e5880, _e5876, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e5927 = ((_e4112.member * _e5915) + (_e4120.member * _e5920));
let _e5928 = ((_e4112.member_1 * _e5915) + (_e4120.member_1 * _e5920));
let _e5929 = ((_e4112.member_2 * _e5915) + (_e4120.member_2 * _e5920));
let _e5933 = select((_e4135.member + _e5927), _e4135.member, _e4133);
let _e5934 = select((_e4135.member_1 + _e5928), _e4135.member_1, _e4133);
let _e5935 = select((_e4135.member_2 + _e5929), _e4135.member_2, _e4133);
let _e5946 = (((_e5933 * _e5933) + (_e5934 * _e5934)) + (_e5935 * _e5935));
let _e5950 = (1f / sqrt(select(0f, _e5946, (_e5946 > 0f))));
let _e5951 = (_e5933 * _e5950);
let _e5952 = (_e5934 * _e5950);
let _e5953 = (_e5935 * _e5950);
let _e5954 = (_e574 - select(_e4146.member, (_e4146.member + _e5927), _e4133));
let _e5955 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e5928), _e4133));
let _e5956 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e5929), _e4133));
let _e5961 = (((_e5954 * _e5951) + (_e5955 * _e5952)) + (_e5956 * _e5953));
let _e5966 = (((_e5954 * _e612) + (_e5955 * _e625)) + (_e5956 * _e638));
let _e5971 = (((_e5951 * _e612) + (_e5952 * _e625)) + (_e5953 * _e638));
let _e5974 = ((_e5952 * _e638) - (_e5953 * _e625));
let _e5977 = ((_e5953 * _e612) - (_e5951 * _e638));
let _e5980 = ((_e5951 * _e625) - (_e5952 * _e612));
let _e5985 = (((_e5974 * _e5974) + (_e5977 * _e5977)) + (_e5980 * _e5980));
let _e5988 = (1f / select(1e-9f, _e5985, (_e5985 > 1e-9f)));
let _e5991 = ((_e5961 - (_e5971 * _e5966)) * _e5988);
let _e5994 = (((_e5971 * _e5961) - _e5966) * _e5988);
let _e6000 = select(0f, _e5991, (((_e5994 >= 0f) && (_e5994 < _e690)) && (_e5991 > 0f)));
let _e6002 = (_e5866 << bitcast<u32>(_e5492));
if _e5714 {
phi_14433_ = (_e5508.member - 1i);
} else {
phi_14433_ = _e5713;
}
let _e6017 = phi_14433_;
if _e5869 {
phi_14444_ = (_e5508.member_1 - 1i);
} else {
phi_14444_ = _e5868;
}
let _e6020 = phi_14444_;
let _e6024 = (((f32(_e6017) + 0.5f) * _e5513) - 0.5f);
let _e6028 = (((f32(_e6020) + 0.5f) * _e5513) - 0.5f);
if _e452 {
phi_14472_ = type_23(_e6020, _e6017);
} else {
phi_14472_ = type_23(_e6017, _e6020);
}
let _e6034 = phi_14472_;
if _e5584 {
phi_14523_ = 0u;
} else {
if (_e987 == 1u) {
phi_14522_ = 0u;
} else {
if (_e987 == 2u) {
phi_14521_ = _e4905;
} else {
phi_14521_ = select(_e4911, _e4908, (_e987 == 3u));
}
let _e6042 = phi_14521_;
phi_14522_ = _e6042;
}
let _e6044 = phi_14522_;
phi_14523_ = _e6044;
}
let _e6046 = phi_14523_;
local_162 = (((bitcast<i32>(_e6046) + _e6034.member_1) * _e4902) + _e6034.member);
let _e6051 = local_162;
let _e6053 = select(_e4928, _e6051, (_e6051 < _e4928));
let _e6058 = global_6.member[bitcast<u32>(select(0i, _e6053, (_e6053 > 0i)))];
let _e6063 = (((((select(_e6024, _e6028, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e6068 = ((1f - (((select(_e6028, _e6024, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e6075 = ((_e4112.member * _e6063) + (_e4120.member * _e6068));
let _e6076 = ((_e4112.member_1 * _e6063) + (_e4120.member_1 * _e6068));
let _e6077 = ((_e4112.member_2 * _e6063) + (_e4120.member_2 * _e6068));
let _e6081 = select((_e4135.member + _e6075), _e4135.member, _e4133);
let _e6082 = select((_e4135.member_1 + _e6076), _e4135.member_1, _e4133);
let _e6083 = select((_e4135.member_2 + _e6077), _e4135.member_2, _e4133);
let _e6094 = (((_e6081 * _e6081) + (_e6082 * _e6082)) + (_e6083 * _e6083));
let _e6098 = (1f / sqrt(select(0f, _e6094, (_e6094 > 0f))));
let _e6099 = (_e6081 * _e6098);
let _e6100 = (_e6082 * _e6098);
let _e6101 = (_e6083 * _e6098);
let _e6102 = (_e574 - select(_e4146.member, (_e4146.member + _e6075), _e4133));
let _e6103 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e6076), _e4133));
let _e6104 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e6077), _e4133));
let _e6109 = (((_e6102 * _e6099) + (_e6103 * _e6100)) + (_e6104 * _e6101));
let _e6114 = (((_e6102 * _e612) + (_e6103 * _e625)) + (_e6104 * _e638));
let _e6119 = (((_e6099 * _e612) + (_e6100 * _e625)) + (_e6101 * _e638));
let _e6122 = ((_e6100 * _e638) - (_e6101 * _e625));
let _e6125 = ((_e6101 * _e612) - (_e6099 * _e638));
let _e6128 = ((_e6099 * _e625) - (_e6100 * _e612));
let _e6133 = (((_e6122 * _e6122) + (_e6125 * _e6125)) + (_e6128 * _e6128));
let _e6136 = (1f / select(1e-9f, _e6133, (_e6133 > 1e-9f)));
let _e6139 = ((_e6109 - (_e6119 * _e6114)) * _e6136);
let _e6142 = (((_e6119 * _e6109) - _e6114) * _e6136);
let _e6148 = select(0f, _e6139, (((_e6142 >= 0f) && (_e6142 < _e690)) && (_e6139 > 0f)));
let _e6150 = (_e6017 << bitcast<u32>(_e5492));
let _e6162 = select(((((_e5491 - select(0f, (_e5553 * _e5554), (((select(select(_e765, _e926, (_e5698 >= _e691)), _e846, (_e5698 < _e297)) == _e987) && (_e5696 > 0f)) && (_e5696 < _e5606)))) - select(0f, (_e5550 * _e5554), (((select(select(_e765, _e926, (_e5850 >= _e691)), _e846, (_e5850 < _e297)) == _e987) && (_e5848 > 0f)) && (_e5848 < _e5758)))) - select(0f, (_e5553 * _e5552), (((select(select(_e765, _e926, (_e6002 >= _e691)), _e846, (_e6002 < _e297)) == _e987) && (_e6000 > 0f)) && (_e6000 < _e5910)))) - select(0f, (_e5550 * _e5552), (((select(select(_e765, _e926, (_e6150 >= _e691)), _e846, (_e6150 < _e297)) == _e987) && (_e6148 > 0f)) && (_e6148 < _e6058)))), _e5491, _e5584);
let _e6163 = (_e991 & 31u);
let _e6165 = (1u << bitcast<u32>(_e6163));
let _e6174 = bitcast<i32>((((_e930 + _e6165) - 1u) >> bitcast<u32>(_e6163)));
let _e6175 = bitcast<i32>((((_e933 + _e6165) - 1u) >> bitcast<u32>(_e6163)));
if _e452 {
phi_15088_ = type_23(_e6175, _e6174);
} else {
phi_15088_ = type_23(_e6174, _e6175);
}
let _e6179 = phi_15088_;
let _e6184 = f32((1i << bitcast<u32>(_e6163)));
let _e6185 = (1f / _e6184);
let _e6187 = ((_e3908 * _e6185) - 0.5f);
let _e6189 = ((_e4001 * _e6185) - 0.5f);
let _e6191 = select(-1f, _e6187, (_e6187 > -1f));
let _e6193 = select(1e6f, _e6191, (_e6191 < 1e6f));
let _e6200 = select(0i, select(select(i32(_e6193), i32(-2147483648), (_e6193 < -2147483600f)), 2147483647i, (_e6193 > 2147483500f)), (_e6193 == _e6193));
let _e6204 = (_e6200 - select(0i, 1i, (_e6193 < f32(_e6200))));
let _e6206 = select(-1f, _e6189, (_e6189 > -1f));
let _e6208 = select(1e6f, _e6206, (_e6206 < 1e6f));
let _e6215 = select(0i, select(select(i32(_e6208), i32(-2147483648), (_e6208 < -2147483600f)), 2147483647i, (_e6208 > 2147483500f)), (_e6208 == _e6208));
let _e6219 = (_e6215 - select(0i, 1i, (_e6208 < f32(_e6215))));
let _e6221 = (_e6187 - f32(_e6204));
let _e6223 = (_e6189 - f32(_e6219));
let _e6224 = (1f - _e6221);
let _e6225 = (1f - _e6223);
let _e6228 = select(_e6204, 0i, (_e6204 < 0i));
let _e6229 = (_e6228 >= _e6179.member);
if _e6229 {
phi_15166_ = (_e6179.member - 1i);
} else {
phi_15166_ = _e6228;
}
let _e6232 = phi_15166_;
let _e6234 = select(_e6219, 0i, (_e6219 < 0i));
let _e6235 = (_e6234 >= _e6179.member_1);
if _e6235 {
phi_15177_ = (_e6179.member_1 - 1i);
} else {
phi_15177_ = _e6234;
}
let _e6238 = phi_15177_;
let _e6242 = (((f32(_e6232) + 0.5f) * _e6184) - 0.5f);
let _e6246 = (((f32(_e6238) + 0.5f) * _e6184) - 0.5f);
if _e452 {
phi_15205_ = type_23(_e6238, _e6232);
} else {
phi_15205_ = type_23(_e6232, _e6238);
}
let _e6252 = phi_15205_;
let _e6255 = (_e991 == 0u);
if _e6255 {
phi_15256_ = 0u;
} else {
if (_e991 == 1u) {
phi_15255_ = 0u;
} else {
if (_e991 == 2u) {
phi_15254_ = _e4905;
} else {
phi_15254_ = select(_e4911, _e4908, (_e991 == 3u));
}
let _e6261 = phi_15254_;
phi_15255_ = _e6261;
}
let _e6263 = phi_15255_;
phi_15256_ = _e6263;
}
let _e6265 = phi_15256_;
local_160 = (((bitcast<i32>(_e6265) + _e6252.member_1) * _e4902) + _e6252.member);
let _e6270 = local_160;
let _e6272 = select(_e4928, _e6270, (_e6270 < _e4928));
let _e6277 = global_6.member[bitcast<u32>(select(0i, _e6272, (_e6272 > 0i)))];
let _e6282 = (((((select(_e6242, _e6246, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e6287 = ((1f - (((select(_e6246, _e6242, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e6294 = ((_e4112.member * _e6282) + (_e4120.member * _e6287));
let _e6295 = ((_e4112.member_1 * _e6282) + (_e4120.member_1 * _e6287));
let _e6296 = ((_e4112.member_2 * _e6282) + (_e4120.member_2 * _e6287));
let _e6300 = select((_e4135.member + _e6294), _e4135.member, _e4133);
let _e6301 = select((_e4135.member_1 + _e6295), _e4135.member_1, _e4133);
let _e6302 = select((_e4135.member_2 + _e6296), _e4135.member_2, _e4133);
let _e6313 = (((_e6300 * _e6300) + (_e6301 * _e6301)) + (_e6302 * _e6302));
let _e6317 = (1f / sqrt(select(0f, _e6313, (_e6313 > 0f))));
let _e6318 = (_e6300 * _e6317);
let _e6319 = (_e6301 * _e6317);
let _e6320 = (_e6302 * _e6317);
let _e6321 = (_e574 - select(_e4146.member, (_e4146.member + _e6294), _e4133));
let _e6322 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e6295), _e4133));
let _e6323 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e6296), _e4133));
let _e6328 = (((_e6321 * _e6318) + (_e6322 * _e6319)) + (_e6323 * _e6320));
let _e6333 = (((_e6321 * _e612) + (_e6322 * _e625)) + (_e6323 * _e638));
let _e6338 = (((_e6318 * _e612) + (_e6319 * _e625)) + (_e6320 * _e638));
let _e6341 = ((_e6319 * _e638) - (_e6320 * _e625));
let _e6344 = ((_e6320 * _e612) - (_e6318 * _e638));
let _e6347 = ((_e6318 * _e625) - (_e6319 * _e612));
let _e6352 = (((_e6341 * _e6341) + (_e6344 * _e6344)) + (_e6347 * _e6347));
let _e6355 = (1f / select(1e-9f, _e6352, (_e6352 > 1e-9f)));
let _e6358 = ((_e6328 - (_e6338 * _e6333)) * _e6355);
let _e6361 = (((_e6338 * _e6328) - _e6333) * _e6355);
let _e6367 = select(0f, _e6358, (((_e6361 >= 0f) && (_e6361 < _e690)) && (_e6358 > 0f)));
let _e6369 = (_e6232 << bitcast<u32>(_e6163));
let _e6381 = (_e6204 + 1i);
let _e6384 = select(_e6381, 0i, (_e6381 < 0i));
let _e6385 = (_e6384 >= _e6179.member);
if _e6385 {
phi_15803_ = (_e6179.member - 1i);
} else {
phi_15803_ = _e6384;
}
let _e6388 = phi_15803_;
if _e6235 {
phi_15814_ = (_e6179.member_1 - 1i);
} else {
phi_15814_ = _e6234;
}
let _e6391 = phi_15814_;
let _e6395 = (((f32(_e6388) + 0.5f) * _e6184) - 0.5f);
let _e6399 = (((f32(_e6391) + 0.5f) * _e6184) - 0.5f);
if _e452 {
phi_15842_ = type_23(_e6391, _e6388);
} else {
phi_15842_ = type_23(_e6388, _e6391);
}
let _e6405 = phi_15842_;
if _e6255 {
phi_15893_ = 0u;
} else {
if (_e991 == 1u) {
phi_15892_ = 0u;
} else {
if (_e991 == 2u) {
phi_15891_ = _e4905;
} else {
phi_15891_ = select(_e4911, _e4908, (_e991 == 3u));
}
let _e6413 = phi_15891_;
phi_15892_ = _e6413;
}
let _e6415 = phi_15892_;
phi_15893_ = _e6415;
}
let _e6417 = phi_15893_;
local_158 = (((bitcast<i32>(_e6417) + _e6405.member_1) * _e4902) + _e6405.member);
let _e6422 = local_158;
let _e6424 = select(_e4928, _e6422, (_e6422 < _e4928));
let _e6429 = global_6.member[bitcast<u32>(select(0i, _e6424, (_e6424 > 0i)))];
let _e6434 = (((((select(_e6395, _e6399, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e6439 = ((1f - (((select(_e6399, _e6395, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e6446 = ((_e4112.member * _e6434) + (_e4120.member * _e6439));
let _e6447 = ((_e4112.member_1 * _e6434) + (_e4120.member_1 * _e6439));
let _e6448 = ((_e4112.member_2 * _e6434) + (_e4120.member_2 * _e6439));
let _e6452 = select((_e4135.member + _e6446), _e4135.member, _e4133);
let _e6453 = select((_e4135.member_1 + _e6447), _e4135.member_1, _e4133);
let _e6454 = select((_e4135.member_2 + _e6448), _e4135.member_2, _e4133);
let _e6465 = (((_e6452 * _e6452) + (_e6453 * _e6453)) + (_e6454 * _e6454));
let _e6469 = (1f / sqrt(select(0f, _e6465, (_e6465 > 0f))));
let _e6470 = (_e6452 * _e6469);
let _e6471 = (_e6453 * _e6469);
let _e6472 = (_e6454 * _e6469);
let _e6473 = (_e574 - select(_e4146.member, (_e4146.member + _e6446), _e4133));
let _e6474 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e6447), _e4133));
let _e6475 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e6448), _e4133));
let _e6480 = (((_e6473 * _e6470) + (_e6474 * _e6471)) + (_e6475 * _e6472));
let _e6485 = (((_e6473 * _e612) + (_e6474 * _e625)) + (_e6475 * _e638));
let _e6490 = (((_e6470 * _e612) + (_e6471 * _e625)) + (_e6472 * _e638));
let _e6493 = ((_e6471 * _e638) - (_e6472 * _e625));
let _e6496 = ((_e6472 * _e612) - (_e6470 * _e638));
let _e6499 = ((_e6470 * _e625) - (_e6471 * _e612));
let _e6504 = (((_e6493 * _e6493) + (_e6496 * _e6496)) + (_e6499 * _e6499));
let _e6507 = (1f / select(1e-9f, _e6504, (_e6504 > 1e-9f)));
let _e6510 = ((_e6480 - (_e6490 * _e6485)) * _e6507);
let _e6513 = (((_e6490 * _e6480) - _e6485) * _e6507);
let _e6519 = select(0f, _e6510, (((_e6513 >= 0f) && (_e6513 < _e690)) && (_e6510 > 0f)));
let _e6521 = (_e6388 << bitcast<u32>(_e6163));
let _e6533 = (_e6219 + 1i);
if _e6229 {
phi_16440_ = (_e6179.member - 1i);
} else {
phi_16440_ = _e6228;
}
let _e6537 = phi_16440_;
let _e6539 = select(_e6533, 0i, (_e6533 < 0i));
let _e6540 = (_e6539 >= _e6179.member_1);
if _e6540 {
phi_16451_ = (_e6179.member_1 - 1i);
} else {
phi_16451_ = _e6539;
}
let _e6543 = phi_16451_;
let _e6547 = (((f32(_e6537) + 0.5f) * _e6184) - 0.5f);
let _e6551 = (((f32(_e6543) + 0.5f) * _e6184) - 0.5f);
if _e452 {
phi_16479_ = type_23(_e6543, _e6537);
} else {
phi_16479_ = type_23(_e6537, _e6543);
}
let _e6557 = phi_16479_;
if _e6255 {
phi_16530_ = 0u;
} else {
if (_e991 == 1u) {
phi_16529_ = 0u;
} else {
if (_e991 == 2u) {
phi_16528_ = _e4905;
} else {
phi_16528_ = select(_e4911, _e4908, (_e991 == 3u));
}
let _e6565 = phi_16528_;
phi_16529_ = _e6565;
}
let _e6567 = phi_16529_;
phi_16530_ = _e6567;
}
let _e6569 = phi_16530_;
local_156 = (((bitcast<i32>(_e6569) + _e6557.member_1) * _e4902) + _e6557.member);
let _e6574 = local_156;
let _e6576 = select(_e4928, _e6574, (_e6574 < _e4928));
let _e6581 = global_6.member[bitcast<u32>(select(0i, _e6576, (_e6576 > 0i)))];
let _e6586 = (((((select(_e6547, _e6551, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e6591 = ((1f - (((select(_e6551, _e6547, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e6598 = ((_e4112.member * _e6586) + (_e4120.member * _e6591));
let _e6599 = ((_e4112.member_1 * _e6586) + (_e4120.member_1 * _e6591));
let _e6600 = ((_e4112.member_2 * _e6586) + (_e4120.member_2 * _e6591));
let _e6604 = select((_e4135.member + _e6598), _e4135.member, _e4133);
let _e6605 = select((_e4135.member_1 + _e6599), _e4135.member_1, _e4133);
let _e6606 = select((_e4135.member_2 + _e6600), _e4135.member_2, _e4133);
let _e6617 = (((_e6604 * _e6604) + (_e6605 * _e6605)) + (_e6606 * _e6606));
let _e6621 = (1f / sqrt(select(0f, _e6617, (_e6617 > 0f))));
let _e6622 = (_e6604 * _e6621);
let _e6623 = (_e6605 * _e6621);
let _e6624 = (_e6606 * _e6621);
let _e6625 = (_e574 - select(_e4146.member, (_e4146.member + _e6598), _e4133));
let _e6626 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e6599), _e4133));
let _e6627 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e6600), _e4133));
let _e6632 = (((_e6625 * _e6622) + (_e6626 * _e6623)) + (_e6627 * _e6624));
let _e6637 = (((_e6625 * _e612) + (_e6626 * _e625)) + (_e6627 * _e638));
let _e6642 = (((_e6622 * _e612) + (_e6623 * _e625)) + (_e6624 * _e638));
let _e6645 = ((_e6623 * _e638) - (_e6624 * _e625));
let _e6648 = ((_e6624 * _e612) - (_e6622 * _e638));
let _e6651 = ((_e6622 * _e625) - (_e6623 * _e612));
let _e6656 = (((_e6645 * _e6645) + (_e6648 * _e6648)) + (_e6651 * _e6651));
let _e6659 = (1f / select(1e-9f, _e6656, (_e6656 > 1e-9f)));
let _e6662 = ((_e6632 - (_e6642 * _e6637)) * _e6659);
let _e6665 = (((_e6642 * _e6632) - _e6637) * _e6659);
let _e6671 = select(0f, _e6662, (((_e6665 >= 0f) && (_e6665 < _e690)) && (_e6662 > 0f)));
let _e6673 = (_e6537 << bitcast<u32>(_e6163));
if _e6385 {
phi_17077_ = (_e6179.member - 1i);
} else {
phi_17077_ = _e6384;
}
let _e6688 = phi_17077_;
if _e6540 {
phi_17088_ = (_e6179.member_1 - 1i);
} else {
phi_17088_ = _e6539;
}
let _e6691 = phi_17088_;
let _e6695 = (((f32(_e6688) + 0.5f) * _e6184) - 0.5f);
let _e6699 = (((f32(_e6691) + 0.5f) * _e6184) - 0.5f);
if _e452 {
phi_17116_ = type_23(_e6691, _e6688);
} else {
phi_17116_ = type_23(_e6688, _e6691);
}
let _e6705 = phi_17116_;
if _e6255 {
phi_17167_ = 0u;
} else {
if (_e991 == 1u) {
phi_17166_ = 0u;
} else {
if (_e991 == 2u) {
phi_17165_ = _e4905;
} else {
phi_17165_ = select(_e4911, _e4908, (_e991 == 3u));
}
let _e6713 = phi_17165_;
phi_17166_ = _e6713;
}
let _e6715 = phi_17166_;
phi_17167_ = _e6715;
}
let _e6717 = phi_17167_;
local_154 = (((bitcast<i32>(_e6717) + _e6705.member_1) * _e4902) + _e6705.member);
let _e6722 = local_154;
let _e6724 = select(_e4928, _e6722, (_e6722 < _e4928));
let _e6729 = global_6.member[bitcast<u32>(select(0i, _e6724, (_e6724 > 0i)))];
let _e6734 = (((((select(_e6695, _e6699, _e452) + 0.5f) / _e4093) * 2f) - 1f) * _e4101);
let _e6739 = ((1f - (((select(_e6699, _e6695, _e452) + 0.5f) / _e4094) * 2f)) * _e4109);
let _e6746 = ((_e4112.member * _e6734) + (_e4120.member * _e6739));
let _e6747 = ((_e4112.member_1 * _e6734) + (_e4120.member_1 * _e6739));
let _e6748 = ((_e4112.member_2 * _e6734) + (_e4120.member_2 * _e6739));
let _e6752 = select((_e4135.member + _e6746), _e4135.member, _e4133);
let _e6753 = select((_e4135.member_1 + _e6747), _e4135.member_1, _e4133);
let _e6754 = select((_e4135.member_2 + _e6748), _e4135.member_2, _e4133);
let _e6765 = (((_e6752 * _e6752) + (_e6753 * _e6753)) + (_e6754 * _e6754));
let _e6769 = (1f / sqrt(select(0f, _e6765, (_e6765 > 0f))));
let _e6770 = (_e6752 * _e6769);
let _e6771 = (_e6753 * _e6769);
let _e6772 = (_e6754 * _e6769);
let _e6773 = (_e574 - select(_e4146.member, (_e4146.member + _e6746), _e4133));
let _e6774 = (_e586 - select(_e4146.member_1, (_e4146.member_1 + _e6747), _e4133));
let _e6775 = (_e599 - select(_e4146.member_2, (_e4146.member_2 + _e6748), _e4133));
let _e6780 = (((_e6773 * _e6770) + (_e6774 * _e6771)) + (_e6775 * _e6772));
let _e6785 = (((_e6773 * _e612) + (_e6774 * _e625)) + (_e6775 * _e638));
let _e6790 = (((_e6770 * _e612) + (_e6771 * _e625)) + (_e6772 * _e638));
let _e6793 = ((_e6771 * _e638) - (_e6772 * _e625));
let _e6796 = ((_e6772 * _e612) - (_e6770 * _e638));
let _e6799 = ((_e6770 * _e625) - (_e6771 * _e612));
let _e6804 = (((_e6793 * _e6793) + (_e6796 * _e6796)) + (_e6799 * _e6799));
let _e6807 = (1f / select(1e-9f, _e6804, (_e6804 > 1e-9f)));
let _e6810 = ((_e6780 - (_e6790 * _e6785)) * _e6807);
let _e6813 = (((_e6790 * _e6780) - _e6785) * _e6807);
let _e6819 = select(0f, _e6810, (((_e6813 >= 0f) && (_e6813 < _e690)) && (_e6810 > 0f)));
let _e6821 = (_e6688 << bitcast<u32>(_e6163));
let _e6833 = select(((((_e6162 - select(0f, (_e6224 * _e6225), (((select(select(_e765, _e926, (_e6369 >= _e691)), _e846, (_e6369 < _e297)) == _e991) && (_e6367 > 0f)) && (_e6367 < _e6277)))) - select(0f, (_e6221 * _e6225), (((select(select(_e765, _e926, (_e6521 >= _e691)), _e846, (_e6521 < _e297)) == _e991) && (_e6519 > 0f)) && (_e6519 < _e6429)))) - select(0f, (_e6224 * _e6223), (((select(select(_e765, _e926, (_e6673 >= _e691)), _e846, (_e6673 < _e297)) == _e991) && (_e6671 > 0f)) && (_e6671 < _e6581)))) - select(0f, (_e6221 * _e6223), (((select(select(_e765, _e926, (_e6821 >= _e691)), _e846, (_e6821 < _e297)) == _e991) && (_e6819 > 0f)) && (_e6819 < _e6729)))), _e6162, _e6255);
if _e452 {
phi_17723_ = type_23(_e3998, _e3906);
} else {
phi_17723_ = type_23(_e3906, _e3998);
}
let _e6848 = phi_17723_;
let _e6851 = (_e3999 && (((_e4806 > 0f) && (_e4806 < _e4089)) && (bitcast<f32>((bitcast<u32>(_e6833) & 2147483647u)) > 1e-6f)));
let _e6854 = global_1.member.member_18.member;
let _e6855 = (((select(_e4024, (1f - _e4024), (_e4009 >= 0f)) - select(_e4043, (1f - _e4043), (_e4028 >= 0f))) * (1f / _e4006)) * _e6854);
let _e6859 = select(0f, (((((_e651 * _e4643.member) * ((1f + (_e4683 * (1f + (_e4683 * (0.5f + (_e4683 * (0.16666667f + (_e4683 * (0.041666668f + (_e4683 * (0.008333334f + (_e4683 * (0.001388889f + (_e4683 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4678 + 127i)) << bitcast<u32>(23i))))) * _e4640) * _e6833) * _e6855), _e6851);
let _e6860 = select(0f, (((((_e664 * _e4643.member_1) * ((1f + (_e4731 * (1f + (_e4731 * (0.5f + (_e4731 * (0.16666667f + (_e4731 * (0.041666668f + (_e4731 * (0.008333334f + (_e4731 * (0.001388889f + (_e4731 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4726 + 127i)) << bitcast<u32>(23i))))) * _e4640) * _e6833) * _e6855), _e6851);
let _e6861 = select(0f, (((((_e677 * _e4643.member_2) * ((1f + (_e4779 * (1f + (_e4779 * (0.5f + (_e4779 * (0.16666667f + (_e4779 * (0.041666668f + (_e4779 * (0.008333334f + (_e4779 * (0.001388889f + (_e4779 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e4774 + 127i)) << bitcast<u32>(23i))))) * _e4640) * _e6833) * _e6855), _e6851);
let _e6865 = (bitcast<f32>((bitcast<u32>(_e6859) & 2147483647u)) >= 1073741800f);
let _e6866 = (1f / 1048576f);
let _e6869 = ((_e6859 * select(1f, _e6866, _e6865)) + 0.5f);
let _e6871 = select(-1073741800f, _e6869, (_e6869 > -1073741800f));
let _e6873 = select(1073741800f, _e6871, (_e6871 < 1073741800f));
let _e6880 = select(0i, select(select(i32(_e6873), i32(-2147483648), (_e6873 < -2147483600f)), 2147483647i, (_e6873 > 2147483500f)), (_e6873 == _e6873));
let _e6884 = (_e6880 - select(0i, 1i, (_e6873 < f32(_e6880))));
let _e6885 = select(0i, 20i, _e6865);
let _e6889 = (bitcast<u32>(_e6884) << bitcast<u32>((_e6885 & 31i)));
let _e6896 = bitcast<u32>(((_e6884 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6885) & 31i))));
let _e6900 = (bitcast<f32>((bitcast<u32>(_e6860) & 2147483647u)) >= 1073741800f);
let _e6903 = ((_e6860 * select(1f, _e6866, _e6900)) + 0.5f);
let _e6905 = select(-1073741800f, _e6903, (_e6903 > -1073741800f));
let _e6907 = select(1073741800f, _e6905, (_e6905 < 1073741800f));
let _e6914 = select(0i, select(select(i32(_e6907), i32(-2147483648), (_e6907 < -2147483600f)), 2147483647i, (_e6907 > 2147483500f)), (_e6907 == _e6907));
let _e6918 = (_e6914 - select(0i, 1i, (_e6907 < f32(_e6914))));
let _e6919 = select(0i, 20i, _e6900);
let _e6923 = (bitcast<u32>(_e6918) << bitcast<u32>((_e6919 & 31i)));
let _e6930 = bitcast<u32>(((_e6918 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6919) & 31i))));
let _e6934 = (bitcast<f32>((bitcast<u32>(_e6861) & 2147483647u)) >= 1073741800f);
let _e6937 = ((_e6861 * select(1f, _e6866, _e6934)) + 0.5f);
let _e6939 = select(-1073741800f, _e6937, (_e6937 > -1073741800f));
let _e6941 = select(1073741800f, _e6939, (_e6939 < 1073741800f));
let _e6948 = select(0i, select(select(i32(_e6941), i32(-2147483648), (_e6941 < -2147483600f)), 2147483647i, (_e6941 > 2147483500f)), (_e6941 == _e6941));
let _e6952 = (_e6948 - select(0i, 1i, (_e6941 < f32(_e6948))));
let _e6953 = select(0i, 20i, _e6934);
let _e6957 = (bitcast<u32>(_e6952) << bitcast<u32>((_e6953 & 31i)));
let _e6964 = bitcast<u32>(((_e6952 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e6953) & 31i))));
let _e6969 = bitcast<i32>(bitcast<u32>((((_e6848.member_1 * _e934) + _e6848.member) * 6i)));
if ((_e6889 | _e6896) == 0u) {
} else {
let _e6972 = bitcast<u32>(_e6969);
if (_e6972 < _e269) {
let _e6976 = atomicAdd((&global_8.member[_e6972]), _e6889);
phi_17956_ = _e6976;
} else {
phi_17956_ = 0u;
}
let _e6978 = phi_17956_;
let _e6982 = (_e6896 + select(0u, 1u, ((_e6978 + _e6889) < _e6889)));
if (_e6982 == 0u) {
} else {
let _e6984 = (_e6972 + 1u);
if (_e6984 < _e269) {
let _e6988 = atomicAdd((&global_8.member[_e6984]), _e6982);
}
}
}
if ((_e6923 | _e6930) == 0u) {
} else {
let _e6992 = bitcast<u32>((_e6969 + 2i));
if (_e6992 < _e269) {
let _e6996 = atomicAdd((&global_8.member[_e6992]), _e6923);
phi_17986_ = _e6996;
} else {
phi_17986_ = 0u;
}
let _e6998 = phi_17986_;
let _e7002 = (_e6930 + select(0u, 1u, ((_e6998 + _e6923) < _e6923)));
if (_e7002 == 0u) {
} else {
let _e7004 = (_e6992 + 1u);
if (_e7004 < _e269) {
let _e7008 = atomicAdd((&global_8.member[_e7004]), _e7002);
}
}
}
if ((_e6957 | _e6964) == 0u) {
} else {
let _e7012 = bitcast<u32>((_e6969 + 4i));
if (_e7012 < _e269) {
let _e7016 = atomicAdd((&global_8.member[_e7012]), _e6957);
phi_18016_ = _e7016;
} else {
phi_18016_ = 0u;
}
let _e7018 = phi_18016_;
let _e7022 = (_e6964 + select(0u, 1u, ((_e7018 + _e6957) < _e6957)));
if (_e7022 == 0u) {
} else {
let _e7024 = (_e7012 + 1u);
if (_e7024 < _e269) {
let _e7028 = atomicAdd((&global_8.member[_e7024]), _e7022);
}
}
}
phi_8522_ = (_e3996 + 1i);
} else {
phi_8522_ = i32();
}
let _e7031 = phi_8522_;
continue;
continuing {
phi_8521_ = _e7031;
break if !(_e3999);
}
}
phi_8368_ = (_e3903 + 1i);
} else {
phi_8368_ = i32();
}
let _e7035 = phi_8368_;
continue;
continuing {
phi_8367_ = _e7035;
break if !(_e3904);
}
}
}
}
} else {
let _e7037 = (_e765 & 31u);
let _e7039 = (1u << bitcast<u32>(_e7037));
let _e7048 = bitcast<i32>((((_e930 + _e7039) - 1u) >> bitcast<u32>(_e7037)));
let _e7049 = bitcast<i32>((((_e933 + _e7039) - 1u) >> bitcast<u32>(_e7037)));
if _e452 {
phi_18082_ = type_23(_e7049, _e7048);
} else {
phi_18082_ = type_23(_e7048, _e7049);
}
let _e7053 = phi_18082_;
let _e7057 = (_e960 >> bitcast<u32>(_e7037));
if (_e7057 < _e7053.member) {
phi_18157_ = _e7057;
} else {
phi_18157_ = (_e7053.member - 1i);
}
let _e7063 = phi_18157_;
phi_18161_ = type_23(2147483647i, -1i);
phi_18164_ = 0i;
loop {
let _e7066 = phi_18161_;
let _e7068 = phi_18164_;
local_231 = _e7066;
local_232 = _e7066;
let _e7069 = (_e7068 < 16i);
if _e7069 {
let _e7071 = (1i << bitcast<u32>(_e7037));
let _e7072 = f32(_e7071);
let _e7074 = ((4u - _e765) & 31u);
let _e7079 = ((_e978 >> bitcast<u32>(_e7037)) + (_e7068 & ((1i << bitcast<u32>(_e7074)) - 1i)));
let _e7083 = (((f32(_e7079) + 0.5f) * _e7072) - 0.5f);
let _e7087 = (-(((_e415 * _e7083) + _e441)) / _e428);
let _e7094 = bitcast<f32>((bitcast<u32>(((_e465 * _e7083) + ((_e478 * _e7087) + _e491))) & 2147483647u));
let _e7101 = bitcast<f32>((bitcast<u32>(((_e504 * _e7083) + ((_e517 * _e7087) + _e530))) & 2147483647u));
let _e7106 = (((0.5f * (_e7094 + _e7101)) / _e533) + (0.5f * _e7072));
let _e7107 = (1f / _e7072);
let _e7115 = ((((_e7087 + _e7106) + 0.5f) * _e7107) - 0.5f);
let _e7116 = f32((_e7053.member_1 - 1i));
let _e7117 = (0f - 1f);
let _e7119 = select(_e7117, _e7115, (_e7115 > _e7117));
let _e7121 = select(_e7116, _e7119, (_e7119 < _e7116));
let _e7128 = select(0i, select(select(i32(_e7121), i32(-2147483648), (_e7121 < -2147483600f)), 2147483647i, (_e7121 > 2147483500f)), (_e7121 == _e7121));
let _e7133 = (((((_e7087 - _e7106) + 0.5f) * _e7107) - 0.5f) + 1f);
let _e7134 = (_e7116 + 1f);
let _e7136 = select(0f, _e7133, (_e7133 > 0f));
let _e7138 = select(_e7134, _e7136, (_e7136 < _e7134));
let _e7145 = select(0i, select(select(i32(_e7138), i32(-2147483648), (_e7138 < -2147483600f)), 2147483647i, (_e7138 > 2147483500f)), (_e7138 == _e7138));
let _e7156 = ((1e-4f * _e7072) * _e533);
let _e7158 = select(_e7101, _e7094, (_e7094 > _e7101));
let _e7160 = select(_e7156, _e7158, (_e7158 > _e7156));
let _e7162 = select(_e7101, _e7094, (_e7094 < _e7101));
let _e7164 = select(_e7156, _e7162, (_e7162 > _e7156));
let _e7166 = (0.5f * (_e7160 + _e7164));
let _e7167 = (0.5f / _e7164);
let _e7168 = (1f / _e7160);
phi_18315_ = _e7066;
phi_18318_ = 0i;
loop {
let _e7170 = phi_18315_;
let _e7172 = phi_18318_;
local_241 = _e7170;
let _e7175 = (((_e7145 - select(0i, 1i, (_e7138 < f32(_e7145)))) + (_e7068 >> bitcast<u32>(_e7074))) + (_e7172 << bitcast<u32>(_e7037)));
let _e7176 = (_e7175 <= select(-1i, (_e7128 - select(0i, 1i, (_e7121 < f32(_e7128)))), (_e7079 <= _e7063)));
if _e7176 {
let _e7180 = (((f32(_e7175) + 0.5f) * _e7072) - 0.5f);
let _e7182 = ((_e7180 - _e7087) * _e533);
let _e7183 = (_e533 * _e7072);
let _e7185 = (0.5f * _e7183);
let _e7186 = (_e7182 + _e7185);
let _e7187 = -(_e7186);
let _e7190 = (_e7166 - select(_e7187, _e7186, (_e7186 > _e7187)));
let _e7192 = select(0f, _e7190, (_e7190 > 0f));
let _e7194 = select(_e7164, _e7192, (_e7192 < _e7164));
let _e7197 = (_e7190 - _e7164);
let _e7201 = (((_e7194 * (_e7194 * _e7167)) + select(0f, _e7197, (_e7197 > 0f))) * _e7168);
let _e7205 = (_e7182 - _e7185);
let _e7206 = -(_e7205);
let _e7209 = (_e7166 - select(_e7206, _e7205, (_e7205 > _e7206)));
let _e7211 = select(0f, _e7209, (_e7209 > 0f));
let _e7213 = select(_e7164, _e7211, (_e7211 < _e7164));
let _e7216 = (_e7209 - _e7164);
let _e7220 = (((_e7213 * (_e7213 * _e7167)) + select(0f, _e7216, (_e7216 > 0f))) * _e7168);
if _e452 {
phi_18448_ = type_23(_e7175, _e7079);
} else {
phi_18448_ = type_23(_e7079, _e7175);
}
let _e7231 = phi_18448_;
let _e7237 = bitcast<i32>(((_e930 + 1u) >> bitcast<u32>(1u)));
let _e7240 = global_1.member.member_18.member_9;
let _e7245 = global_1.member.member_18.member_6;
let _e7248 = global_1.member.member_18.member_7;
let _e7251 = global_1.member.member_18.member_8;
if _e985 {
phi_18499_ = 0u;
} else {
if (_e765 == 1u) {
phi_18498_ = 0u;
} else {
if (_e765 == 2u) {
phi_18497_ = _e7245;
} else {
phi_18497_ = select(_e7251, _e7248, (_e765 == 3u));
}
let _e7257 = phi_18497_;
phi_18498_ = _e7257;
}
let _e7259 = phi_18498_;
phi_18499_ = _e7259;
}
let _e7261 = phi_18499_;
local_152 = (((bitcast<i32>(_e7261) + _e7231.member_1) * _e7237) + _e7231.member);
local_153 = (_e7237 * bitcast<i32>(_e7240));
let _e7266 = local_152;
let _e7268 = (bitcast<i32>(_e261) - 1i);
let _e7270 = select(_e7268, _e7266, (_e7266 < _e7268));
let _e7275 = global_6.member[bitcast<u32>(select(0i, _e7270, (_e7270 > 0i)))];
let _e7276 = local_153;
let _e7277 = local_152;
let _e7278 = (_e7276 + _e7277);
let _e7280 = select(_e7268, _e7278, (_e7278 < _e7268));
let _e7285 = global_6.member[bitcast<u32>(select(0i, _e7280, (_e7280 > 0i)))];
let _e7286 = local_153;
let _e7288 = local_152;
let _e7289 = ((2i * _e7286) + _e7288);
let _e7291 = select(_e7268, _e7289, (_e7289 < _e7268));
let _e7296 = global_6.member[bitcast<u32>(select(0i, _e7291, (_e7291 > 0i)))];
let _e7298 = (_e7071 >> bitcast<u32>(1i));
let _e7301 = ((_e7231.member << bitcast<u32>(_e7037)) + _e7298);
let _e7304 = ((_e7231.member_1 << bitcast<u32>(_e7037)) + _e7298);
let _e7306 = select(_e7301, 0i, (_e7301 < 0i));
if (_e7306 >= _e934) {
phi_18625_ = (_e934 - 1i);
} else {
phi_18625_ = _e7306;
}
let _e7310 = phi_18625_;
let _e7312 = select(_e7304, 0i, (_e7304 < 0i));
if (_e7312 >= _e935) {
phi_18636_ = (_e935 - 1i);
} else {
phi_18636_ = _e7312;
}
let _e7316 = phi_18636_;
let _e7318 = bitcast<i32>((_e930 * _e933));
local_150 = _e7318;
local_151 = ((_e7316 * _e934) + _e7310);
let _e7321 = local_150;
let _e7322 = local_151;
let _e7323 = (_e7321 + _e7322);
let _e7325 = (bitcast<i32>(_e258) - 1i);
let _e7327 = select(_e7325, _e7323, (_e7323 < _e7325));
let _e7332 = global_5.member[bitcast<u32>(select(0i, _e7327, (_e7327 > 0i)))];
let _e7333 = local_150;
let _e7335 = local_151;
let _e7336 = ((2i * _e7333) + _e7335);
let _e7338 = select(_e7325, _e7336, (_e7336 < _e7325));
let _e7343 = global_5.member[bitcast<u32>(select(0i, _e7338, (_e7338 > 0i)))];
let _e7344 = local_151;
let _e7353 = global_1.member.member_2.member;
let _e7354 = (((((select(_e7083, _e7180, _e452) + 0.5f) / f32(_e934)) * 2f) - 1f) * _e7353);
let _e7361 = global_1.member.member_2.member_1;
let _e7362 = ((1f - (((select(_e7180, _e7083, _e452) + 0.5f) / f32(_e935)) * 2f)) * _e7361);
let _e7364 = global_1.member.member_3;
let _e7372 = global_1.member.member_4;
let _e7379 = ((_e7364.member * _e7354) + (_e7372.member * _e7362));
let _e7380 = ((_e7364.member_1 * _e7354) + (_e7372.member_1 * _e7362));
let _e7381 = ((_e7364.member_2 * _e7354) + (_e7372.member_2 * _e7362));
let _e7384 = global_1.member.member_2.member_3;
let _e7385 = (_e7384 != 0u);
let _e7387 = global_1.member.member_5;
let _e7394 = select((_e7387.member + _e7379), _e7387.member, _e7385);
let _e7395 = select((_e7387.member_1 + _e7380), _e7387.member_1, _e7385);
let _e7396 = select((_e7387.member_2 + _e7381), _e7387.member_2, _e7385);
let _e7398 = global_1.member.member_6;
let _e7405 = select(_e7398.member, (_e7398.member + _e7379), _e7385);
let _e7406 = select(_e7398.member_1, (_e7398.member_1 + _e7380), _e7385);
let _e7407 = select(_e7398.member_2, (_e7398.member_2 + _e7381), _e7385);
let _e7412 = (((_e7394 * _e7394) + (_e7395 * _e7395)) + (_e7396 * _e7396));
let _e7415 = sqrt(select(0f, _e7412, (_e7412 > 0f)));
let _e7416 = (1f / _e7415);
let _e7417 = (_e7394 * _e7416);
let _e7418 = (_e7395 * _e7416);
let _e7419 = (_e7396 * _e7416);
let _e7420 = (_e574 - _e7405);
let _e7421 = (_e586 - _e7406);
let _e7422 = (_e599 - _e7407);
let _e7427 = (((_e7420 * _e7417) + (_e7421 * _e7418)) + (_e7422 * _e7419));
let _e7432 = (((_e7420 * _e612) + (_e7421 * _e625)) + (_e7422 * _e638));
let _e7437 = (((_e7417 * _e612) + (_e7418 * _e625)) + (_e7419 * _e638));
let _e7440 = ((_e7418 * _e638) - (_e7419 * _e625));
let _e7443 = ((_e7419 * _e612) - (_e7417 * _e638));
let _e7446 = ((_e7417 * _e625) - (_e7418 * _e612));
let _e7451 = (((_e7440 * _e7440) + (_e7443 * _e7443)) + (_e7446 * _e7446));
let _e7454 = (1f / select(1e-9f, _e7451, (_e7451 > 1e-9f)));
let _e7457 = ((_e7427 - (_e7437 * _e7432)) * _e7454);
let _e7460 = (((_e7437 * _e7427) - _e7432) * _e7454);
let _e7466 = -(_e7437);
let _e7469 = global_1.member.member_13.member_2;
let _e7470 = (_e7469 * _e7469);
let _e7474 = ((1f + _e7470) - ((2f * _e7469) * _e7466));
let _e7476 = select(1e-9f, _e7474, (_e7474 > 1e-9f));
let _e7488 = global_1.member.member_13.member_3;
let _e7496 = global_1.member.member_12.member_10;
let _e7499 = global_1.member.member_12.member_4;
let _e7502 = global_1.member.member_12.member_11;
let _e7508 = global_1.member.member.member;
let _e7510 = (_e7460 / _e690);
local_147 = bitcast<i32>((_e7496 + (_e7499 * _e7502)));
local_148 = _e280;
local_149 = bitcast<i32>(_e7508);
let _e7513 = global_1.member.member_13.member_6;
let _e7514 = f32(_e7513);
let _e7516 = select(0f, _e7510, (_e7510 > 0f));
let _e7519 = (select(1f, _e7516, (_e7516 < 1f)) * _e7514);
let _e7520 = (_e7514 - 1f);
let _e7522 = select(0f, _e7520, (_e7520 > 0f));
let _e7524 = select(0f, _e7519, (_e7519 > 0f));
let _e7526 = select(_e7522, _e7524, (_e7524 < _e7522));
let _e7533 = select(0i, select(select(i32(_e7526), i32(-2147483648), (_e7526 < -2147483600f)), 2147483647i, (_e7526 > 2147483500f)), (_e7526 == _e7526));
let _e7537 = (_e7533 - select(0i, 1i, (_e7526 < f32(_e7533))));
if (_e7537 > 0i) {
let _e7540 = local_147;
let _e7541 = local_149;
let _e7544 = local_148;
let _e7545 = ((_e7540 + ((_e7537 - 1i) * _e7541)) + _e7544);
let _e7547 = (bitcast<i32>(_e267) - 1i);
let _e7549 = select(_e7547, _e7545, (_e7545 < _e7547));
let _e7554 = global_7.member[bitcast<u32>(select(0i, _e7549, (_e7549 > 0i)))];
phi_19045_ = _e7554;
} else {
phi_19045_ = 0f;
}
let _e7556 = phi_19045_;
let _e7557 = local_147;
let _e7558 = local_149;
let _e7561 = local_148;
let _e7562 = ((_e7557 + (_e7537 * _e7558)) + _e7561);
let _e7564 = (bitcast<i32>(_e267) - 1i);
let _e7566 = select(_e7564, _e7562, (_e7562 < _e7564));
let _e7571 = global_7.member[bitcast<u32>(select(0i, _e7566, (_e7566 > 0i)))];
let _e7578 = (_e7343 - _e7332);
let _e7581 = ((_e7457 - _e7332) / select(1e-9f, _e7578, (_e7578 > 1e-9f)));
local_144 = 0i;
local_145 = _e7344;
local_146 = _e7318;
let _e7583 = select(0f, _e7581, (_e7581 > 0f));
let _e7586 = (select(1f, _e7583, (_e7583 < 1f)) * _e7514);
let _e7588 = select(0f, _e7586, (_e7586 > 0f));
let _e7590 = select(_e7522, _e7588, (_e7588 < _e7522));
let _e7597 = select(0i, select(select(i32(_e7590), i32(-2147483648), (_e7590 < -2147483600f)), 2147483647i, (_e7590 > 2147483500f)), (_e7590 == _e7590));
let _e7601 = (_e7597 - select(0i, 1i, (_e7590 < f32(_e7597))));
if (_e7601 > 0i) {
let _e7604 = local_144;
let _e7605 = local_146;
let _e7608 = local_145;
let _e7609 = ((_e7604 + ((_e7601 - 1i) * _e7605)) + _e7608);
let _e7611 = select(_e7564, _e7609, (_e7609 < _e7564));
let _e7616 = global_7.member[bitcast<u32>(select(0i, _e7611, (_e7611 > 0i)))];
phi_19172_ = _e7616;
} else {
phi_19172_ = 0f;
}
let _e7618 = phi_19172_;
let _e7619 = local_144;
let _e7620 = local_146;
let _e7623 = local_145;
let _e7624 = ((_e7619 + (_e7601 * _e7620)) + _e7623);
let _e7626 = select(_e7564, _e7624, (_e7624 < _e7564));
let _e7631 = global_7.member[bitcast<u32>(select(0i, _e7626, (_e7626 > 0i)))];
let _e7637 = ((_e7556 + ((_e7571 - _e7556) * (_e7519 - f32(_e7537)))) + (_e7618 + ((_e7631 - _e7618) * (_e7586 - f32(_e7601)))));
let _e7646 = global_1.member.member_13.member_7;
let _e7647 = bitcast<i32>(_e7646);
let _e7650 = global_1.member.member_13.member_8;
let _e7651 = bitcast<i32>(_e7650);
let _e7654 = global_1.member.member_13.member_9;
let _e7655 = bitcast<i32>(_e7654);
let _e7658 = global_1.member.member_13.member_4;
let _e7664 = global_1.member.member_13.member_5;
let _e7668 = f32(_e7647);
let _e7673 = (((((_e7405 + (_e7417 * _e7457)) - _e7658.member) / (_e7664.member - _e7658.member)) * _e7668) - 0.5f);
let _e7674 = (_e7668 - 1f);
let _e7676 = select(0f, _e7673, (_e7673 > 0f));
let _e7678 = select(_e7674, _e7676, (_e7676 < _e7674));
let _e7679 = f32(_e7651);
let _e7684 = (((((_e7406 + (_e7418 * _e7457)) - _e7658.member_1) / (_e7664.member_1 - _e7658.member_1)) * _e7679) - 0.5f);
let _e7685 = (_e7679 - 1f);
let _e7687 = select(0f, _e7684, (_e7684 > 0f));
let _e7689 = select(_e7685, _e7687, (_e7687 < _e7685));
let _e7690 = f32(_e7655);
let _e7695 = (((((_e7407 + (_e7419 * _e7457)) - _e7658.member_2) / (_e7664.member_2 - _e7658.member_2)) * _e7690) - 0.5f);
let _e7696 = (_e7690 - 1f);
let _e7698 = select(0f, _e7695, (_e7695 > 0f));
let _e7700 = select(_e7696, _e7698, (_e7698 < _e7696));
let _e7702 = select(0f, _e7678, (_e7678 > 0f));
let _e7704 = select(1e6f, _e7702, (_e7702 < 1e6f));
let _e7711 = select(0i, select(select(i32(_e7704), i32(-2147483648), (_e7704 < -2147483600f)), 2147483647i, (_e7704 > 2147483500f)), (_e7704 == _e7704));
let _e7715 = (_e7711 - select(0i, 1i, (_e7704 < f32(_e7711))));
let _e7717 = select(0f, _e7689, (_e7689 > 0f));
let _e7719 = select(1e6f, _e7717, (_e7717 < 1e6f));
let _e7726 = select(0i, select(select(i32(_e7719), i32(-2147483648), (_e7719 < -2147483600f)), 2147483647i, (_e7719 > 2147483500f)), (_e7719 == _e7719));
let _e7730 = (_e7726 - select(0i, 1i, (_e7719 < f32(_e7726))));
let _e7732 = select(0f, _e7700, (_e7700 > 0f));
let _e7734 = select(1e6f, _e7732, (_e7732 < 1e6f));
let _e7741 = select(0i, select(select(i32(_e7734), i32(-2147483648), (_e7734 < -2147483600f)), 2147483647i, (_e7734 > 2147483500f)), (_e7734 == _e7734));
let _e7745 = (_e7741 - select(0i, 1i, (_e7734 < f32(_e7741))));
let _e7749 = (_e7689 - f32(_e7730));
let _e7751 = (_e7700 - f32(_e7745));
local_142 = (_e7678 - f32(_e7715));
let _e7752 = (_e7715 + 1i);
let _e7754 = select(_e7752, 0i, (_e7752 < 0i));
if (_e7754 >= _e7647) {
phi_19320_ = (_e7647 - 1i);
} else {
phi_19320_ = _e7754;
}
let _e7758 = phi_19320_;
local_143 = (_e7758 - _e7715);
let _e7760 = (_e7730 + 1i);
let _e7762 = select(_e7760, 0i, (_e7760 < 0i));
if (_e7762 >= _e7651) {
phi_19333_ = (_e7651 - 1i);
} else {
phi_19333_ = _e7762;
}
let _e7766 = phi_19333_;
let _e7768 = ((_e7766 - _e7730) * _e7647);
let _e7769 = (_e7745 + 1i);
let _e7771 = select(_e7769, 0i, (_e7769 < 0i));
if (_e7771 >= _e7655) {
phi_19347_ = (_e7655 - 1i);
} else {
phi_19347_ = _e7771;
}
let _e7775 = phi_19347_;
let _e7781 = global_1.member.member_13.member_10;
let _e7787 = ((bitcast<i32>(_e7781) + (((_e7745 * _e7651) + _e7730) * _e7647)) + _e7715);
let _e7789 = (bitcast<i32>(_e264) - 1i);
let _e7791 = select(_e7789, _e7787, (_e7787 < _e7789));
let _e7796 = global_2.member[bitcast<u32>(select(0i, _e7791, (_e7791 > 0i)))];
let _e7797 = local_142;
let _e7800 = local_143;
let _e7801 = (_e7787 + _e7800);
let _e7803 = select(_e7789, _e7801, (_e7801 < _e7789));
let _e7808 = global_2.member[bitcast<u32>(select(0i, _e7803, (_e7803 > 0i)))];
let _e7809 = local_142;
let _e7812 = (1f - _e7749);
let _e7814 = (_e7787 + _e7768);
let _e7816 = select(_e7789, _e7814, (_e7814 < _e7789));
let _e7821 = global_2.member[bitcast<u32>(select(0i, _e7816, (_e7816 > 0i)))];
let _e7822 = local_142;
let _e7825 = local_143;
let _e7826 = (_e7814 + _e7825);
let _e7828 = select(_e7789, _e7826, (_e7826 < _e7789));
let _e7833 = global_2.member[bitcast<u32>(select(0i, _e7828, (_e7828 > 0i)))];
let _e7834 = local_142;
let _e7839 = (_e7787 + (((_e7775 - _e7745) * _e7647) * _e7651));
let _e7841 = select(_e7789, _e7839, (_e7839 < _e7789));
let _e7846 = global_2.member[bitcast<u32>(select(0i, _e7841, (_e7841 > 0i)))];
let _e7847 = local_142;
let _e7850 = local_143;
let _e7851 = (_e7839 + _e7850);
let _e7853 = select(_e7789, _e7851, (_e7851 < _e7789));
let _e7858 = global_2.member[bitcast<u32>(select(0i, _e7853, (_e7853 > 0i)))];
let _e7859 = local_142;
let _e7863 = (_e7839 + _e7768);
let _e7865 = select(_e7789, _e7863, (_e7863 < _e7789));
let _e7870 = global_2.member[bitcast<u32>(select(0i, _e7865, (_e7865 > 0i)))];
let _e7871 = local_142;
let _e7874 = local_143;
let _e7875 = (_e7863 + _e7874);
let _e7877 = select(_e7789, _e7875, (_e7875 < _e7789));
let _e7882 = global_2.member[bitcast<u32>(select(0i, _e7877, (_e7877 > 0i)))];
let _e7883 = local_142;
let _e7892 = ((_e7415 * (select(((1f - _e7470) / (_e7476 * sqrt(select(0f, _e7476, (_e7476 > 0f))))), (0.75f * (1f + (_e7466 * _e7466))), (_e7488 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e7796 * (1f - _e7797)) + (_e7808 * _e7809)) * _e7812) + (((_e7821 * (1f - _e7822)) + (_e7833 * _e7834)) * _e7749)) * (1f - _e7751)) + (((((_e7846 * (1f - _e7847)) + (_e7858 * _e7859)) * _e7812) + (((_e7870 * (1f - _e7871)) + (_e7882 * _e7883)) * _e7749)) * _e7751)));
let _e7895 = global_1.member.member_13.member_1;
let _e7904 = global_1.member.member_13.member;
let _e7909 = -((_e7904.member * _e7637));
let _e7911 = select(-87f, _e7909, (_e7909 > -87f));
let _e7913 = select(88f, _e7911, (_e7911 < 88f));
let _e7915 = ((_e7913 * 1.442695f) + 0.5f);
let _e7917 = select(-127f, _e7915, (_e7915 > -127f));
let _e7919 = select(128f, _e7917, (_e7917 < 128f));
let _e7926 = select(0i, select(select(i32(_e7919), i32(-2147483648), (_e7919 < -2147483600f)), 2147483647i, (_e7919 > 2147483500f)), (_e7919 == _e7919));
let _e7930 = (_e7926 - select(0i, 1i, (_e7919 < f32(_e7926))));
let _e7931 = f32(_e7930);
let _e7935 = ((_e7913 - (_e7931 * 0.6933594f)) - (_e7931 * -2.1219444e-4f));
let _e7957 = -((_e7904.member_1 * _e7637));
let _e7959 = select(-87f, _e7957, (_e7957 > -87f));
let _e7961 = select(88f, _e7959, (_e7959 < 88f));
let _e7963 = ((_e7961 * 1.442695f) + 0.5f);
let _e7965 = select(-127f, _e7963, (_e7963 > -127f));
let _e7967 = select(128f, _e7965, (_e7965 < 128f));
let _e7974 = select(0i, select(select(i32(_e7967), i32(-2147483648), (_e7967 < -2147483600f)), 2147483647i, (_e7967 > 2147483500f)), (_e7967 == _e7967));
let _e7978 = (_e7974 - select(0i, 1i, (_e7967 < f32(_e7974))));
let _e7979 = f32(_e7978);
let _e7983 = ((_e7961 - (_e7979 * 0.6933594f)) - (_e7979 * -2.1219444e-4f));
let _e8005 = -((_e7904.member_2 * _e7637));
let _e8007 = select(-87f, _e8005, (_e8005 > -87f));
let _e8009 = select(88f, _e8007, (_e8007 < 88f));
let _e8011 = ((_e8009 * 1.442695f) + 0.5f);
let _e8013 = select(-127f, _e8011, (_e8011 > -127f));
let _e8015 = select(128f, _e8013, (_e8013 < 128f));
let _e8022 = select(0i, select(select(i32(_e8015), i32(-2147483648), (_e8015 < -2147483600f)), 2147483647i, (_e8015 > 2147483500f)), (_e8015 == _e8015));
let _e8026 = (_e8022 - select(0i, 1i, (_e8015 < f32(_e8022))));
let _e8027 = f32(_e8026);
let _e8031 = ((_e8009 - (_e8027 * 0.6933594f)) - (_e8027 * -2.1219444e-4f));
let _e8058 = select(0f, _e7457, (((_e7460 >= 0f) && (_e7460 < _e690)) && (_e7457 > 0f)));
let _e8061 = ((_e8058 > 0f) && (_e8058 < _e7275));
if _e452 {
phi_19803_ = type_23(_e7175, _e7079);
} else {
phi_19803_ = type_23(_e7079, _e7175);
}
let _e8085 = phi_19803_;
let _e8088 = (_e7176 && _e8061);
let _e8091 = global_1.member.member_18.member;
let _e8092 = (((select(_e7201, (1f - _e7201), (_e7186 >= 0f)) - select(_e7220, (1f - _e7220), (_e7205 >= 0f))) * (1f / _e7183)) * _e8091);
let _e8096 = select(0f, ((((_e651 * _e7895.member) * ((1f + (_e7935 * (1f + (_e7935 * (0.5f + (_e7935 * (0.16666667f + (_e7935 * (0.041666668f + (_e7935 * (0.008333334f + (_e7935 * (0.001388889f + (_e7935 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7930 + 127i)) << bitcast<u32>(23i))))) * _e7892) * _e8092), _e8088);
let _e8097 = select(0f, ((((_e664 * _e7895.member_1) * ((1f + (_e7983 * (1f + (_e7983 * (0.5f + (_e7983 * (0.16666667f + (_e7983 * (0.041666668f + (_e7983 * (0.008333334f + (_e7983 * (0.001388889f + (_e7983 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e7978 + 127i)) << bitcast<u32>(23i))))) * _e7892) * _e8092), _e8088);
let _e8098 = select(0f, ((((_e677 * _e7895.member_2) * ((1f + (_e8031 * (1f + (_e8031 * (0.5f + (_e8031 * (0.16666667f + (_e8031 * (0.041666668f + (_e8031 * (0.008333334f + (_e8031 * (0.001388889f + (_e8031 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e8026 + 127i)) << bitcast<u32>(23i))))) * _e7892) * _e8092), _e8088);
let _e8102 = (bitcast<f32>((bitcast<u32>(_e8096) & 2147483647u)) >= 1073741800f);
let _e8103 = (1f / 1048576f);
let _e8106 = ((_e8096 * select(1f, _e8103, _e8102)) + 0.5f);
let _e8108 = select(-1073741800f, _e8106, (_e8106 > -1073741800f));
let _e8110 = select(1073741800f, _e8108, (_e8108 < 1073741800f));
let _e8117 = select(0i, select(select(i32(_e8110), i32(-2147483648), (_e8110 < -2147483600f)), 2147483647i, (_e8110 > 2147483500f)), (_e8110 == _e8110));
let _e8121 = (_e8117 - select(0i, 1i, (_e8110 < f32(_e8117))));
let _e8122 = select(0i, 20i, _e8102);
let _e8126 = (bitcast<u32>(_e8121) << bitcast<u32>((_e8122 & 31i)));
let _e8133 = bitcast<u32>(((_e8121 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8122) & 31i))));
let _e8137 = (bitcast<f32>((bitcast<u32>(_e8097) & 2147483647u)) >= 1073741800f);
let _e8140 = ((_e8097 * select(1f, _e8103, _e8137)) + 0.5f);
let _e8142 = select(-1073741800f, _e8140, (_e8140 > -1073741800f));
let _e8144 = select(1073741800f, _e8142, (_e8142 < 1073741800f));
let _e8151 = select(0i, select(select(i32(_e8144), i32(-2147483648), (_e8144 < -2147483600f)), 2147483647i, (_e8144 > 2147483500f)), (_e8144 == _e8144));
let _e8155 = (_e8151 - select(0i, 1i, (_e8144 < f32(_e8151))));
let _e8156 = select(0i, 20i, _e8137);
let _e8160 = (bitcast<u32>(_e8155) << bitcast<u32>((_e8156 & 31i)));
let _e8167 = bitcast<u32>(((_e8155 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8156) & 31i))));
let _e8171 = (bitcast<f32>((bitcast<u32>(_e8098) & 2147483647u)) >= 1073741800f);
let _e8174 = ((_e8098 * select(1f, _e8103, _e8171)) + 0.5f);
let _e8176 = select(-1073741800f, _e8174, (_e8174 > -1073741800f));
let _e8178 = select(1073741800f, _e8176, (_e8176 < 1073741800f));
let _e8185 = select(0i, select(select(i32(_e8178), i32(-2147483648), (_e8178 < -2147483600f)), 2147483647i, (_e8178 > 2147483500f)), (_e8178 == _e8178));
let _e8189 = (_e8185 - select(0i, 1i, (_e8178 < f32(_e8185))));
let _e8190 = select(0i, 20i, _e8171);
let _e8194 = (bitcast<u32>(_e8189) << bitcast<u32>((_e8190 & 31i)));
let _e8201 = bitcast<u32>(((_e8189 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e8190) & 31i))));
let _e8206 = global_1.member.member_18.member_2;
let _e8209 = global_1.member.member_18.member_3;
let _e8212 = global_1.member.member_18.member_4;
let _e8215 = global_1.member.member_18.member_5;
if _e985 {
phi_20002_ = 0u;
} else {
if (_e765 == 1u) {
phi_20001_ = _e8206;
} else {
if (_e765 == 2u) {
phi_20000_ = _e8209;
} else {
phi_20000_ = select(_e8215, _e8212, (_e765 == 3u));
}
let _e8221 = phi_20000_;
phi_20001_ = _e8221;
}
let _e8223 = phi_20001_;
phi_20002_ = _e8223;
}
let _e8225 = phi_20002_;
let _e8233 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e8225) + (_e8085.member_1 * _e7048)) + _e8085.member) * 6i)));
if ((_e8126 | _e8133) == 0u) {
} else {
let _e8236 = bitcast<u32>(_e8233);
if (_e8236 < _e269) {
let _e8240 = atomicAdd((&global_8.member[_e8236]), _e8126);
phi_20036_ = _e8240;
} else {
phi_20036_ = 0u;
}
let _e8242 = phi_20036_;
let _e8246 = (_e8133 + select(0u, 1u, ((_e8242 + _e8126) < _e8126)));
if (_e8246 == 0u) {
} else {
let _e8248 = (_e8236 + 1u);
if (_e8248 < _e269) {
let _e8252 = atomicAdd((&global_8.member[_e8248]), _e8246);
}
}
}
if ((_e8160 | _e8167) == 0u) {
} else {
let _e8256 = bitcast<u32>((_e8233 + 2i));
if (_e8256 < _e269) {
let _e8260 = atomicAdd((&global_8.member[_e8256]), _e8160);
phi_20066_ = _e8260;
} else {
phi_20066_ = 0u;
}
let _e8262 = phi_20066_;
let _e8266 = (_e8167 + select(0u, 1u, ((_e8262 + _e8160) < _e8160)));
if (_e8266 == 0u) {
} else {
let _e8268 = (_e8256 + 1u);
if (_e8268 < _e269) {
let _e8272 = atomicAdd((&global_8.member[_e8268]), _e8266);
}
}
}
if ((_e8194 | _e8201) == 0u) {
} else {
let _e8276 = bitcast<u32>((_e8233 + 4i));
if (_e8276 < _e269) {
let _e8280 = atomicAdd((&global_8.member[_e8276]), _e8194);
phi_20096_ = _e8280;
} else {
phi_20096_ = 0u;
}
let _e8282 = phi_20096_;
let _e8286 = (_e8201 + select(0u, 1u, ((_e8282 + _e8194) < _e8194)));
if (_e8286 == 0u) {
} else {
let _e8288 = (_e8276 + 1u);
if (_e8288 < _e269) {
let _e8292 = atomicAdd((&global_8.member[_e8288]), _e8286);
}
}
}
let _e8293 = bitcast<i32>(bitcast<u32>(select(-1i, _e7175, (_e7176 && (!(((_e8061 && !(((((_e7079 * _e7071) == _e297) && (_e846 != _e765)) || ((((_e7079 + 1i) * _e7071) == _e691) && (_e926 != _e765))))) && ((_e8058 * (1f + (0.02f * _e7072))) < _e7296))) && (_e8058 <= _e7285))))));
if (_e8293 >= 0i) {
phi_20133_ = type_23(select(_e7170.member, _e8293, (_e8293 < _e7170.member)), select(_e7170.member_1, _e8293, (_e8293 > _e7170.member_1)));
} else {
phi_20133_ = _e7170;
}
let _e8303 = phi_20133_;
phi_18316_ = _e8303;
phi_18319_ = (_e7172 + 1i);
} else {
phi_18316_ = type_23();
phi_18319_ = i32();
}
let _e8306 = phi_18316_;
let _e8308 = phi_18319_;
continue;
continuing {
phi_18315_ = _e8306;
phi_18318_ = _e8308;
break if !(_e7176);
}
}
let _e25190 = local_241;
phi_18162_ = _e25190;
phi_18165_ = (_e7068 + 1i);
} else {
phi_18162_ = type_23();
phi_18165_ = i32();
}
let _e8312 = phi_18162_;
let _e8314 = phi_18165_;
continue;
continuing {
phi_18161_ = _e8312;
phi_18164_ = _e8314;
break if !(_e7069);
}
}
let _e8317 = local_231;
let _e8320 = local_232;
if (_e8317.member <= _e8320.member_1) {
let _e8325 = ((_e8320.member_1 + 1i) << bitcast<u32>(_e7037));
if (_e8325 <= _e984) {
phi_20150_ = (_e8325 - 1i);
} else {
phi_20150_ = _e984;
}
let _e8329 = phi_20150_;
let _e8331 = (_e8317.member << bitcast<u32>(_e7037));
let _e8333 = select(_e846, 0u, (_e846 == _e765));
let _e8337 = select(_e926, 0u, ((_e926 == _e765) || (_e926 == _e846)));
let _e8345 = ((select(0u, 1u, (_e765 > 0u)) + select(0u, 1u, (_e8333 > 0u))) + select(0u, 1u, (_e8337 > 0u)));
if (_e8345 == 0u) {
phi_20185_ = 0i;
loop {
let _e8348 = phi_20185_;
let _e8349 = (_e8348 < 16i);
if _e8349 {
let _e8351 = (_e979 + (_e8348 & 15i));
let _e8355 = (((f32(_e8351) + 0.5f) * 1f) - 0.5f);
let _e8359 = (-(((_e415 * _e8355) + _e441)) / _e428);
let _e8366 = bitcast<f32>((bitcast<u32>(((_e465 * _e8355) + ((_e478 * _e8359) + _e491))) & 2147483647u));
let _e8373 = bitcast<f32>((bitcast<u32>(((_e504 * _e8355) + ((_e517 * _e8359) + _e530))) & 2147483647u));
let _e8377 = (((0.5f * (_e8366 + _e8373)) / _e533) + _e716);
let _e8378 = (1f / 1f);
let _e8386 = ((((_e8359 + _e8377) + 0.5f) * _e8378) - 0.5f);
let _e8387 = f32(_e8331);
let _e8388 = f32(_e8329);
let _e8389 = (_e8387 - 1f);
let _e8391 = select(_e8389, _e8386, (_e8386 > _e8389));
let _e8393 = select(_e8388, _e8391, (_e8391 < _e8388));
let _e8400 = select(0i, select(select(i32(_e8393), i32(-2147483648), (_e8393 < -2147483600f)), 2147483647i, (_e8393 > 2147483500f)), (_e8393 == _e8393));
let _e8405 = (((((_e8359 - _e8377) + 0.5f) * _e8378) - 0.5f) + 1f);
let _e8406 = (_e8388 + 1f);
let _e8408 = select(_e8387, _e8405, (_e8405 > _e8387));
let _e8410 = select(_e8406, _e8408, (_e8408 < _e8406));
let _e8417 = select(0i, select(select(i32(_e8410), i32(-2147483648), (_e8410 < -2147483600f)), 2147483647i, (_e8410 > 2147483500f)), (_e8410 == _e8410));
let _e8428 = ((1e-4f * 1f) * _e533);
let _e8430 = select(_e8373, _e8366, (_e8366 > _e8373));
let _e8432 = select(_e8428, _e8430, (_e8430 > _e8428));
let _e8434 = select(_e8373, _e8366, (_e8366 < _e8373));
let _e8436 = select(_e8428, _e8434, (_e8434 > _e8428));
let _e8438 = (0.5f * (_e8432 + _e8436));
let _e8439 = (0.5f / _e8436);
let _e8440 = (1f / _e8432);
phi_20339_ = 0i;
loop {
let _e8442 = phi_20339_;
let _e8444 = (((_e8417 - select(0i, 1i, (_e8410 < f32(_e8417)))) + (_e8348 >> bitcast<u32>(4u))) + bitcast<i32>(_e8442));
let _e8445 = (_e8444 <= select(-1i, (_e8400 - select(0i, 1i, (_e8393 < f32(_e8400)))), (_e8351 <= _e983)));
if _e8445 {
let _e8451 = (((((f32(_e8444) + 0.5f) * 1f) - 0.5f) - _e8359) * _e533);
let _e8452 = (_e533 * 1f);
let _e8454 = (0.5f * _e8452);
let _e8455 = (_e8451 + _e8454);
let _e8456 = -(_e8455);
let _e8459 = (_e8438 - select(_e8456, _e8455, (_e8455 > _e8456)));
let _e8461 = select(0f, _e8459, (_e8459 > 0f));
let _e8463 = select(_e8436, _e8461, (_e8461 < _e8436));
let _e8466 = (_e8459 - _e8436);
let _e8470 = (((_e8463 * (_e8463 * _e8439)) + select(0f, _e8466, (_e8466 > 0f))) * _e8440);
let _e8474 = (_e8451 - _e8454);
let _e8475 = -(_e8474);
let _e8478 = (_e8438 - select(_e8475, _e8474, (_e8474 > _e8475)));
let _e8480 = select(0f, _e8478, (_e8478 > 0f));
let _e8482 = select(_e8436, _e8480, (_e8480 < _e8436));
let _e8485 = (_e8478 - _e8436);
let _e8489 = (((_e8482 * (_e8482 * _e8439)) + select(0f, _e8485, (_e8485 > 0f))) * _e8440);
if _e452 {
phi_20444_ = type_23(_e8444, _e8351);
} else {
phi_20444_ = type_23(_e8351, _e8444);
}
let _e8498 = phi_20444_;
let _e8502 = bitcast<i32>((_e930 * _e933));
local_140 = _e8502;
local_141 = ((_e8498.member_1 * _e934) + _e8498.member);
let _e8505 = local_140;
let _e8506 = local_141;
let _e8507 = (_e8505 + _e8506);
let _e8509 = (bitcast<i32>(_e258) - 1i);
let _e8511 = select(_e8509, _e8507, (_e8507 < _e8509));
let _e8516 = global_5.member[bitcast<u32>(select(0i, _e8511, (_e8511 > 0i)))];
let _e8517 = local_140;
let _e8519 = local_141;
let _e8520 = ((2i * _e8517) + _e8519);
let _e8522 = select(_e8509, _e8520, (_e8520 < _e8509));
let _e8527 = global_5.member[bitcast<u32>(select(0i, _e8522, (_e8522 > 0i)))];
let _e8528 = local_141;
let _e8530 = select(_e8509, _e8528, (_e8528 < _e8509));
let _e8535 = global_5.member[bitcast<u32>(select(0i, _e8530, (_e8530 > 0i)))];
let _e8536 = local_141;
let _e8547 = global_1.member.member_2.member;
let _e8548 = (((((f32(_e8498.member) + 0.5f) / f32(_e934)) * 2f) - 1f) * _e8547);
let _e8555 = global_1.member.member_2.member_1;
let _e8556 = ((1f - (((f32(_e8498.member_1) + 0.5f) / f32(_e935)) * 2f)) * _e8555);
let _e8558 = global_1.member.member_3;
let _e8566 = global_1.member.member_4;
let _e8573 = ((_e8558.member * _e8548) + (_e8566.member * _e8556));
let _e8574 = ((_e8558.member_1 * _e8548) + (_e8566.member_1 * _e8556));
let _e8575 = ((_e8558.member_2 * _e8548) + (_e8566.member_2 * _e8556));
let _e8578 = global_1.member.member_2.member_3;
let _e8579 = (_e8578 != 0u);
let _e8581 = global_1.member.member_5;
let _e8588 = select((_e8581.member + _e8573), _e8581.member, _e8579);
let _e8589 = select((_e8581.member_1 + _e8574), _e8581.member_1, _e8579);
let _e8590 = select((_e8581.member_2 + _e8575), _e8581.member_2, _e8579);
let _e8592 = global_1.member.member_6;
let _e8599 = select(_e8592.member, (_e8592.member + _e8573), _e8579);
let _e8600 = select(_e8592.member_1, (_e8592.member_1 + _e8574), _e8579);
let _e8601 = select(_e8592.member_2, (_e8592.member_2 + _e8575), _e8579);
let _e8606 = (((_e8588 * _e8588) + (_e8589 * _e8589)) + (_e8590 * _e8590));
let _e8609 = sqrt(select(0f, _e8606, (_e8606 > 0f)));
let _e8610 = (1f / _e8609);
let _e8611 = (_e8588 * _e8610);
let _e8612 = (_e8589 * _e8610);
let _e8613 = (_e8590 * _e8610);
let _e8614 = (_e574 - _e8599);
let _e8615 = (_e586 - _e8600);
let _e8616 = (_e599 - _e8601);
let _e8621 = (((_e8614 * _e8611) + (_e8615 * _e8612)) + (_e8616 * _e8613));
let _e8626 = (((_e8614 * _e612) + (_e8615 * _e625)) + (_e8616 * _e638));
let _e8631 = (((_e8611 * _e612) + (_e8612 * _e625)) + (_e8613 * _e638));
let _e8634 = ((_e8612 * _e638) - (_e8613 * _e625));
let _e8637 = ((_e8613 * _e612) - (_e8611 * _e638));
let _e8640 = ((_e8611 * _e625) - (_e8612 * _e612));
let _e8645 = (((_e8634 * _e8634) + (_e8637 * _e8637)) + (_e8640 * _e8640));
let _e8648 = (1f / select(1e-9f, _e8645, (_e8645 > 1e-9f)));
let _e8651 = ((_e8621 - (_e8631 * _e8626)) * _e8648);
let _e8654 = (((_e8631 * _e8621) - _e8626) * _e8648);
let _e8660 = -(_e8631);
let _e8663 = global_1.member.member_13.member_2;
let _e8664 = (_e8663 * _e8663);
let _e8668 = ((1f + _e8664) - ((2f * _e8663) * _e8660));
let _e8670 = select(1e-9f, _e8668, (_e8668 > 1e-9f));
let _e8682 = global_1.member.member_13.member_3;
let _e8690 = global_1.member.member_12.member_10;
let _e8693 = global_1.member.member_12.member_4;
let _e8696 = global_1.member.member_12.member_11;
let _e8702 = global_1.member.member.member;
let _e8704 = (_e8654 / _e690);
local_137 = bitcast<i32>((_e8690 + (_e8693 * _e8696)));
local_138 = _e280;
local_139 = bitcast<i32>(_e8702);
let _e8707 = global_1.member.member_13.member_6;
let _e8708 = f32(_e8707);
let _e8710 = select(0f, _e8704, (_e8704 > 0f));
let _e8713 = (select(1f, _e8710, (_e8710 < 1f)) * _e8708);
let _e8714 = (_e8708 - 1f);
let _e8716 = select(0f, _e8714, (_e8714 > 0f));
let _e8718 = select(0f, _e8713, (_e8713 > 0f));
let _e8720 = select(_e8716, _e8718, (_e8718 < _e8716));
let _e8727 = select(0i, select(select(i32(_e8720), i32(-2147483648), (_e8720 < -2147483600f)), 2147483647i, (_e8720 > 2147483500f)), (_e8720 == _e8720));
let _e8731 = (_e8727 - select(0i, 1i, (_e8720 < f32(_e8727))));
if (_e8731 > 0i) {
let _e8734 = local_137;
let _e8735 = local_139;
let _e8738 = local_138;
let _e8739 = ((_e8734 + ((_e8731 - 1i) * _e8735)) + _e8738);
let _e8741 = (bitcast<i32>(_e267) - 1i);
let _e8743 = select(_e8741, _e8739, (_e8739 < _e8741));
let _e8748 = global_7.member[bitcast<u32>(select(0i, _e8743, (_e8743 > 0i)))];
phi_20857_ = _e8748;
} else {
phi_20857_ = 0f;
}
let _e8750 = phi_20857_;
let _e8751 = local_137;
let _e8752 = local_139;
let _e8755 = local_138;
let _e8756 = ((_e8751 + (_e8731 * _e8752)) + _e8755);
let _e8758 = (bitcast<i32>(_e267) - 1i);
let _e8760 = select(_e8758, _e8756, (_e8756 < _e8758));
let _e8765 = global_7.member[bitcast<u32>(select(0i, _e8760, (_e8760 > 0i)))];
let _e8772 = (_e8527 - _e8516);
let _e8775 = ((_e8651 - _e8516) / select(1e-9f, _e8772, (_e8772 > 1e-9f)));
local_134 = 0i;
local_135 = _e8536;
local_136 = _e8502;
let _e8777 = select(0f, _e8775, (_e8775 > 0f));
let _e8780 = (select(1f, _e8777, (_e8777 < 1f)) * _e8708);
let _e8782 = select(0f, _e8780, (_e8780 > 0f));
let _e8784 = select(_e8716, _e8782, (_e8782 < _e8716));
let _e8791 = select(0i, select(select(i32(_e8784), i32(-2147483648), (_e8784 < -2147483600f)), 2147483647i, (_e8784 > 2147483500f)), (_e8784 == _e8784));
let _e8795 = (_e8791 - select(0i, 1i, (_e8784 < f32(_e8791))));
if (_e8795 > 0i) {
let _e8798 = local_134;
let _e8799 = local_136;
let _e8802 = local_135;
let _e8803 = ((_e8798 + ((_e8795 - 1i) * _e8799)) + _e8802);
let _e8805 = select(_e8758, _e8803, (_e8803 < _e8758));
let _e8810 = global_7.member[bitcast<u32>(select(0i, _e8805, (_e8805 > 0i)))];
phi_20984_ = _e8810;
} else {
phi_20984_ = 0f;
}
let _e8812 = phi_20984_;
let _e8813 = local_134;
let _e8814 = local_136;
let _e8817 = local_135;
let _e8818 = ((_e8813 + (_e8795 * _e8814)) + _e8817);
let _e8820 = select(_e8758, _e8818, (_e8818 < _e8758));
let _e8825 = global_7.member[bitcast<u32>(select(0i, _e8820, (_e8820 > 0i)))];
let _e8831 = ((_e8750 + ((_e8765 - _e8750) * (_e8713 - f32(_e8731)))) + (_e8812 + ((_e8825 - _e8812) * (_e8780 - f32(_e8795)))));
let _e8840 = global_1.member.member_13.member_7;
let _e8841 = bitcast<i32>(_e8840);
let _e8844 = global_1.member.member_13.member_8;
let _e8845 = bitcast<i32>(_e8844);
let _e8848 = global_1.member.member_13.member_9;
let _e8849 = bitcast<i32>(_e8848);
let _e8852 = global_1.member.member_13.member_4;
let _e8858 = global_1.member.member_13.member_5;
let _e8862 = f32(_e8841);
let _e8867 = (((((_e8599 + (_e8611 * _e8651)) - _e8852.member) / (_e8858.member - _e8852.member)) * _e8862) - 0.5f);
let _e8868 = (_e8862 - 1f);
let _e8870 = select(0f, _e8867, (_e8867 > 0f));
let _e8872 = select(_e8868, _e8870, (_e8870 < _e8868));
let _e8873 = f32(_e8845);
let _e8878 = (((((_e8600 + (_e8612 * _e8651)) - _e8852.member_1) / (_e8858.member_1 - _e8852.member_1)) * _e8873) - 0.5f);
let _e8879 = (_e8873 - 1f);
let _e8881 = select(0f, _e8878, (_e8878 > 0f));
let _e8883 = select(_e8879, _e8881, (_e8881 < _e8879));
let _e8884 = f32(_e8849);
let _e8889 = (((((_e8601 + (_e8613 * _e8651)) - _e8852.member_2) / (_e8858.member_2 - _e8852.member_2)) * _e8884) - 0.5f);
let _e8890 = (_e8884 - 1f);
let _e8892 = select(0f, _e8889, (_e8889 > 0f));
let _e8894 = select(_e8890, _e8892, (_e8892 < _e8890));
let _e8896 = select(0f, _e8872, (_e8872 > 0f));
let _e8898 = select(1e6f, _e8896, (_e8896 < 1e6f));
let _e8905 = select(0i, select(select(i32(_e8898), i32(-2147483648), (_e8898 < -2147483600f)), 2147483647i, (_e8898 > 2147483500f)), (_e8898 == _e8898));
let _e8909 = (_e8905 - select(0i, 1i, (_e8898 < f32(_e8905))));
let _e8911 = select(0f, _e8883, (_e8883 > 0f));
let _e8913 = select(1e6f, _e8911, (_e8911 < 1e6f));
let _e8920 = select(0i, select(select(i32(_e8913), i32(-2147483648), (_e8913 < -2147483600f)), 2147483647i, (_e8913 > 2147483500f)), (_e8913 == _e8913));
let _e8924 = (_e8920 - select(0i, 1i, (_e8913 < f32(_e8920))));
let _e8926 = select(0f, _e8894, (_e8894 > 0f));
let _e8928 = select(1e6f, _e8926, (_e8926 < 1e6f));
let _e8935 = select(0i, select(select(i32(_e8928), i32(-2147483648), (_e8928 < -2147483600f)), 2147483647i, (_e8928 > 2147483500f)), (_e8928 == _e8928));
let _e8939 = (_e8935 - select(0i, 1i, (_e8928 < f32(_e8935))));
let _e8943 = (_e8883 - f32(_e8924));
let _e8945 = (_e8894 - f32(_e8939));
local_132 = (_e8872 - f32(_e8909));
let _e8946 = (_e8909 + 1i);
let _e8948 = select(_e8946, 0i, (_e8946 < 0i));
if (_e8948 >= _e8841) {
phi_21132_ = (_e8841 - 1i);
} else {
phi_21132_ = _e8948;
}
let _e8952 = phi_21132_;
local_133 = (_e8952 - _e8909);
let _e8954 = (_e8924 + 1i);
let _e8956 = select(_e8954, 0i, (_e8954 < 0i));
if (_e8956 >= _e8845) {
phi_21145_ = (_e8845 - 1i);
} else {
phi_21145_ = _e8956;
}
let _e8960 = phi_21145_;
let _e8962 = ((_e8960 - _e8924) * _e8841);
let _e8963 = (_e8939 + 1i);
let _e8965 = select(_e8963, 0i, (_e8963 < 0i));
if (_e8965 >= _e8849) {
phi_21159_ = (_e8849 - 1i);
} else {
phi_21159_ = _e8965;
}
let _e8969 = phi_21159_;
let _e8975 = global_1.member.member_13.member_10;
let _e8981 = ((bitcast<i32>(_e8975) + (((_e8939 * _e8845) + _e8924) * _e8841)) + _e8909);
let _e8983 = (bitcast<i32>(_e264) - 1i);
let _e8985 = select(_e8983, _e8981, (_e8981 < _e8983));
let _e8990 = global_2.member[bitcast<u32>(select(0i, _e8985, (_e8985 > 0i)))];
let _e8991 = local_132;
let _e8994 = local_133;
let _e8995 = (_e8981 + _e8994);
let _e8997 = select(_e8983, _e8995, (_e8995 < _e8983));
let _e9002 = global_2.member[bitcast<u32>(select(0i, _e8997, (_e8997 > 0i)))];
let _e9003 = local_132;
let _e9006 = (1f - _e8943);
let _e9008 = (_e8981 + _e8962);
let _e9010 = select(_e8983, _e9008, (_e9008 < _e8983));
let _e9015 = global_2.member[bitcast<u32>(select(0i, _e9010, (_e9010 > 0i)))];
let _e9016 = local_132;
let _e9019 = local_133;
let _e9020 = (_e9008 + _e9019);
let _e9022 = select(_e8983, _e9020, (_e9020 < _e8983));
let _e9027 = global_2.member[bitcast<u32>(select(0i, _e9022, (_e9022 > 0i)))];
let _e9028 = local_132;
let _e9033 = (_e8981 + (((_e8969 - _e8939) * _e8841) * _e8845));
let _e9035 = select(_e8983, _e9033, (_e9033 < _e8983));
let _e9040 = global_2.member[bitcast<u32>(select(0i, _e9035, (_e9035 > 0i)))];
let _e9041 = local_132;
let _e9044 = local_133;
let _e9045 = (_e9033 + _e9044);
let _e9047 = select(_e8983, _e9045, (_e9045 < _e8983));
let _e9052 = global_2.member[bitcast<u32>(select(0i, _e9047, (_e9047 > 0i)))];
let _e9053 = local_132;
let _e9057 = (_e9033 + _e8962);
let _e9059 = select(_e8983, _e9057, (_e9057 < _e8983));
let _e9064 = global_2.member[bitcast<u32>(select(0i, _e9059, (_e9059 > 0i)))];
let _e9065 = local_132;
let _e9068 = local_133;
let _e9069 = (_e9057 + _e9068);
let _e9071 = select(_e8983, _e9069, (_e9069 < _e8983));
let _e9076 = global_2.member[bitcast<u32>(select(0i, _e9071, (_e9071 > 0i)))];
let _e9077 = local_132;
let _e9086 = ((_e8609 * (select(((1f - _e8664) / (_e8670 * sqrt(select(0f, _e8670, (_e8670 > 0f))))), (0.75f * (1f + (_e8660 * _e8660))), (_e8682 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e8990 * (1f - _e8991)) + (_e9002 * _e9003)) * _e9006) + (((_e9015 * (1f - _e9016)) + (_e9027 * _e9028)) * _e8943)) * (1f - _e8945)) + (((((_e9040 * (1f - _e9041)) + (_e9052 * _e9053)) * _e9006) + (((_e9064 * (1f - _e9065)) + (_e9076 * _e9077)) * _e8943)) * _e8945)));
let _e9089 = global_1.member.member_13.member_1;
let _e9098 = global_1.member.member_13.member;
let _e9103 = -((_e9098.member * _e8831));
let _e9105 = select(-87f, _e9103, (_e9103 > -87f));
let _e9107 = select(88f, _e9105, (_e9105 < 88f));
let _e9109 = ((_e9107 * 1.442695f) + 0.5f);
let _e9111 = select(-127f, _e9109, (_e9109 > -127f));
let _e9113 = select(128f, _e9111, (_e9111 < 128f));
let _e9120 = select(0i, select(select(i32(_e9113), i32(-2147483648), (_e9113 < -2147483600f)), 2147483647i, (_e9113 > 2147483500f)), (_e9113 == _e9113));
let _e9124 = (_e9120 - select(0i, 1i, (_e9113 < f32(_e9120))));
let _e9125 = f32(_e9124);
let _e9129 = ((_e9107 - (_e9125 * 0.6933594f)) - (_e9125 * -2.1219444e-4f));
let _e9151 = -((_e9098.member_1 * _e8831));
let _e9153 = select(-87f, _e9151, (_e9151 > -87f));
let _e9155 = select(88f, _e9153, (_e9153 < 88f));
let _e9157 = ((_e9155 * 1.442695f) + 0.5f);
let _e9159 = select(-127f, _e9157, (_e9157 > -127f));
let _e9161 = select(128f, _e9159, (_e9159 < 128f));
let _e9168 = select(0i, select(select(i32(_e9161), i32(-2147483648), (_e9161 < -2147483600f)), 2147483647i, (_e9161 > 2147483500f)), (_e9161 == _e9161));
let _e9172 = (_e9168 - select(0i, 1i, (_e9161 < f32(_e9168))));
let _e9173 = f32(_e9172);
let _e9177 = ((_e9155 - (_e9173 * 0.6933594f)) - (_e9173 * -2.1219444e-4f));
let _e9199 = -((_e9098.member_2 * _e8831));
let _e9201 = select(-87f, _e9199, (_e9199 > -87f));
let _e9203 = select(88f, _e9201, (_e9201 < 88f));
let _e9205 = ((_e9203 * 1.442695f) + 0.5f);
let _e9207 = select(-127f, _e9205, (_e9205 > -127f));
let _e9209 = select(128f, _e9207, (_e9207 < 128f));
let _e9216 = select(0i, select(select(i32(_e9209), i32(-2147483648), (_e9209 < -2147483600f)), 2147483647i, (_e9209 > 2147483500f)), (_e9209 == _e9209));
let _e9220 = (_e9216 - select(0i, 1i, (_e9209 < f32(_e9216))));
let _e9221 = f32(_e9220);
let _e9225 = ((_e9203 - (_e9221 * 0.6933594f)) - (_e9221 * -2.1219444e-4f));
let _e9252 = select(0f, _e8651, (((_e8654 >= 0f) && (_e8654 < _e690)) && (_e8651 > 0f)));
if _e452 {
phi_21594_ = type_23(_e8444, _e8351);
} else {
phi_21594_ = type_23(_e8351, _e8444);
}
let _e9263 = phi_21594_;
let _e9266 = (_e8445 && (((_e9252 > 0f) && (_e9252 < _e8535)) && true));
let _e9269 = global_1.member.member_18.member;
let _e9270 = (((select(_e8470, (1f - _e8470), (_e8455 >= 0f)) - select(_e8489, (1f - _e8489), (_e8474 >= 0f))) * (1f / _e8452)) * _e9269);
let _e9274 = select(0f, (((((_e651 * _e9089.member) * ((1f + (_e9129 * (1f + (_e9129 * (0.5f + (_e9129 * (0.16666667f + (_e9129 * (0.041666668f + (_e9129 * (0.008333334f + (_e9129 * (0.001388889f + (_e9129 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9124 + 127i)) << bitcast<u32>(23i))))) * _e9086) * 1f) * _e9270), _e9266);
let _e9275 = select(0f, (((((_e664 * _e9089.member_1) * ((1f + (_e9177 * (1f + (_e9177 * (0.5f + (_e9177 * (0.16666667f + (_e9177 * (0.041666668f + (_e9177 * (0.008333334f + (_e9177 * (0.001388889f + (_e9177 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9172 + 127i)) << bitcast<u32>(23i))))) * _e9086) * 1f) * _e9270), _e9266);
let _e9276 = select(0f, (((((_e677 * _e9089.member_2) * ((1f + (_e9225 * (1f + (_e9225 * (0.5f + (_e9225 * (0.16666667f + (_e9225 * (0.041666668f + (_e9225 * (0.008333334f + (_e9225 * (0.001388889f + (_e9225 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e9220 + 127i)) << bitcast<u32>(23i))))) * _e9086) * 1f) * _e9270), _e9266);
let _e9280 = (bitcast<f32>((bitcast<u32>(_e9274) & 2147483647u)) >= 1073741800f);
let _e9281 = (1f / 1048576f);
let _e9284 = ((_e9274 * select(1f, _e9281, _e9280)) + 0.5f);
let _e9286 = select(-1073741800f, _e9284, (_e9284 > -1073741800f));
let _e9288 = select(1073741800f, _e9286, (_e9286 < 1073741800f));
let _e9295 = select(0i, select(select(i32(_e9288), i32(-2147483648), (_e9288 < -2147483600f)), 2147483647i, (_e9288 > 2147483500f)), (_e9288 == _e9288));
let _e9299 = (_e9295 - select(0i, 1i, (_e9288 < f32(_e9295))));
let _e9300 = select(0i, 20i, _e9280);
let _e9304 = (bitcast<u32>(_e9299) << bitcast<u32>((_e9300 & 31i)));
let _e9311 = bitcast<u32>(((_e9299 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9300) & 31i))));
let _e9315 = (bitcast<f32>((bitcast<u32>(_e9275) & 2147483647u)) >= 1073741800f);
let _e9318 = ((_e9275 * select(1f, _e9281, _e9315)) + 0.5f);
let _e9320 = select(-1073741800f, _e9318, (_e9318 > -1073741800f));
let _e9322 = select(1073741800f, _e9320, (_e9320 < 1073741800f));
let _e9329 = select(0i, select(select(i32(_e9322), i32(-2147483648), (_e9322 < -2147483600f)), 2147483647i, (_e9322 > 2147483500f)), (_e9322 == _e9322));
let _e9333 = (_e9329 - select(0i, 1i, (_e9322 < f32(_e9329))));
let _e9334 = select(0i, 20i, _e9315);
let _e9338 = (bitcast<u32>(_e9333) << bitcast<u32>((_e9334 & 31i)));
let _e9345 = bitcast<u32>(((_e9333 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9334) & 31i))));
let _e9349 = (bitcast<f32>((bitcast<u32>(_e9276) & 2147483647u)) >= 1073741800f);
let _e9352 = ((_e9276 * select(1f, _e9281, _e9349)) + 0.5f);
let _e9354 = select(-1073741800f, _e9352, (_e9352 > -1073741800f));
let _e9356 = select(1073741800f, _e9354, (_e9354 < 1073741800f));
let _e9363 = select(0i, select(select(i32(_e9356), i32(-2147483648), (_e9356 < -2147483600f)), 2147483647i, (_e9356 > 2147483500f)), (_e9356 == _e9356));
let _e9367 = (_e9363 - select(0i, 1i, (_e9356 < f32(_e9363))));
let _e9368 = select(0i, 20i, _e9349);
let _e9372 = (bitcast<u32>(_e9367) << bitcast<u32>((_e9368 & 31i)));
let _e9379 = bitcast<u32>(((_e9367 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e9368) & 31i))));
let _e9384 = bitcast<i32>(bitcast<u32>((((_e9263.member_1 * _e934) + _e9263.member) * 6i)));
if ((_e9304 | _e9311) == 0u) {
} else {
let _e9387 = bitcast<u32>(_e9384);
if (_e9387 < _e269) {
let _e9391 = atomicAdd((&global_8.member[_e9387]), _e9304);
phi_21827_ = _e9391;
} else {
phi_21827_ = 0u;
}
let _e9393 = phi_21827_;
let _e9397 = (_e9311 + select(0u, 1u, ((_e9393 + _e9304) < _e9304)));
if (_e9397 == 0u) {
} else {
let _e9399 = (_e9387 + 1u);
if (_e9399 < _e269) {
let _e9403 = atomicAdd((&global_8.member[_e9399]), _e9397);
}
}
}
if ((_e9338 | _e9345) == 0u) {
} else {
let _e9407 = bitcast<u32>((_e9384 + 2i));
if (_e9407 < _e269) {
let _e9411 = atomicAdd((&global_8.member[_e9407]), _e9338);
phi_21857_ = _e9411;
} else {
phi_21857_ = 0u;
}
let _e9413 = phi_21857_;
let _e9417 = (_e9345 + select(0u, 1u, ((_e9413 + _e9338) < _e9338)));
if (_e9417 == 0u) {
} else {
let _e9419 = (_e9407 + 1u);
if (_e9419 < _e269) {
let _e9423 = atomicAdd((&global_8.member[_e9419]), _e9417);
}
}
}
if ((_e9372 | _e9379) == 0u) {
} else {
let _e9427 = bitcast<u32>((_e9384 + 4i));
if (_e9427 < _e269) {
let _e9431 = atomicAdd((&global_8.member[_e9427]), _e9372);
phi_21887_ = _e9431;
} else {
phi_21887_ = 0u;
}
let _e9433 = phi_21887_;
let _e9437 = (_e9379 + select(0u, 1u, ((_e9433 + _e9372) < _e9372)));
if (_e9437 == 0u) {
} else {
let _e9439 = (_e9427 + 1u);
if (_e9439 < _e269) {
let _e9443 = atomicAdd((&global_8.member[_e9439]), _e9437);
}
}
}
phi_20340_ = (_e8442 + 1i);
} else {
phi_20340_ = i32();
}
let _e9446 = phi_20340_;
continue;
continuing {
phi_20339_ = _e9446;
break if !(_e8445);
}
}
phi_20186_ = (_e8348 + 1i);
} else {
phi_20186_ = i32();
}
let _e9450 = phi_20186_;
continue;
continuing {
phi_20185_ = _e9450;
break if !(_e8349);
}
}
} else {
if (_e8345 == 1u) {
phi_21936_ = 0i;
loop {
let _e9454 = phi_21936_;
let _e9455 = (_e9454 < 16i);
if _e9455 {
let _e9457 = (_e979 + (_e9454 & 15i));
let _e9459 = (f32(_e9457) + 0.5f);
let _e9461 = ((_e9459 * 1f) - 0.5f);
let _e9465 = (-(((_e415 * _e9461) + _e441)) / _e428);
let _e9472 = bitcast<f32>((bitcast<u32>(((_e465 * _e9461) + ((_e478 * _e9465) + _e491))) & 2147483647u));
let _e9479 = bitcast<f32>((bitcast<u32>(((_e504 * _e9461) + ((_e517 * _e9465) + _e530))) & 2147483647u));
let _e9483 = (((0.5f * (_e9472 + _e9479)) / _e533) + _e716);
let _e9484 = (1f / 1f);
let _e9492 = ((((_e9465 + _e9483) + 0.5f) * _e9484) - 0.5f);
let _e9493 = f32(_e8331);
let _e9494 = f32(_e8329);
let _e9495 = (_e9493 - 1f);
let _e9497 = select(_e9495, _e9492, (_e9492 > _e9495));
let _e9499 = select(_e9494, _e9497, (_e9497 < _e9494));
let _e9506 = select(0i, select(select(i32(_e9499), i32(-2147483648), (_e9499 < -2147483600f)), 2147483647i, (_e9499 > 2147483500f)), (_e9499 == _e9499));
let _e9511 = (((((_e9465 - _e9483) + 0.5f) * _e9484) - 0.5f) + 1f);
let _e9512 = (_e9494 + 1f);
let _e9514 = select(_e9493, _e9511, (_e9511 > _e9493));
let _e9516 = select(_e9512, _e9514, (_e9514 < _e9512));
let _e9523 = select(0i, select(select(i32(_e9516), i32(-2147483648), (_e9516 < -2147483600f)), 2147483647i, (_e9516 > 2147483500f)), (_e9516 == _e9516));
let _e9534 = ((1e-4f * 1f) * _e533);
let _e9536 = select(_e9479, _e9472, (_e9472 > _e9479));
let _e9538 = select(_e9534, _e9536, (_e9536 > _e9534));
let _e9540 = select(_e9479, _e9472, (_e9472 < _e9479));
let _e9542 = select(_e9534, _e9540, (_e9540 > _e9534));
let _e9544 = (0.5f * (_e9538 + _e9542));
let _e9545 = (0.5f / _e9542);
let _e9546 = (1f / _e9538);
phi_22090_ = 0i;
loop {
let _e9548 = phi_22090_;
let _e9550 = (((_e9523 - select(0i, 1i, (_e9516 < f32(_e9523)))) + (_e9454 >> bitcast<u32>(4u))) + bitcast<i32>(_e9548));
let _e9551 = (_e9550 <= select(-1i, (_e9506 - select(0i, 1i, (_e9499 < f32(_e9506)))), (_e9457 <= _e983)));
if _e9551 {
let _e9553 = (f32(_e9550) + 0.5f);
let _e9557 = ((((_e9553 * 1f) - 0.5f) - _e9465) * _e533);
let _e9558 = (_e533 * 1f);
let _e9560 = (0.5f * _e9558);
let _e9561 = (_e9557 + _e9560);
let _e9562 = -(_e9561);
let _e9565 = (_e9544 - select(_e9562, _e9561, (_e9561 > _e9562)));
let _e9567 = select(0f, _e9565, (_e9565 > 0f));
let _e9569 = select(_e9542, _e9567, (_e9567 < _e9542));
let _e9572 = (_e9565 - _e9542);
let _e9576 = (((_e9569 * (_e9569 * _e9545)) + select(0f, _e9572, (_e9572 > 0f))) * _e9546);
let _e9580 = (_e9557 - _e9560);
let _e9581 = -(_e9580);
let _e9584 = (_e9544 - select(_e9581, _e9580, (_e9580 > _e9581)));
let _e9586 = select(0f, _e9584, (_e9584 > 0f));
let _e9588 = select(_e9542, _e9586, (_e9586 < _e9542));
let _e9591 = (_e9584 - _e9542);
let _e9595 = (((_e9588 * (_e9588 * _e9545)) + select(0f, _e9591, (_e9591 > 0f))) * _e9546);
if _e452 {
phi_22195_ = type_23(_e9550, _e9457);
} else {
phi_22195_ = type_23(_e9457, _e9550);
}
let _e9604 = phi_22195_;
let _e9608 = bitcast<i32>((_e930 * _e933));
local_130 = _e9608;
local_131 = ((_e9604.member_1 * _e934) + _e9604.member);
let _e9611 = local_130;
let _e9612 = local_131;
let _e9613 = (_e9611 + _e9612);
let _e9615 = (bitcast<i32>(_e258) - 1i);
let _e9617 = select(_e9615, _e9613, (_e9613 < _e9615));
let _e9622 = global_5.member[bitcast<u32>(select(0i, _e9617, (_e9617 > 0i)))];
let _e9623 = local_130;
let _e9625 = local_131;
let _e9626 = ((2i * _e9623) + _e9625);
let _e9628 = select(_e9615, _e9626, (_e9626 < _e9615));
let _e9633 = global_5.member[bitcast<u32>(select(0i, _e9628, (_e9628 > 0i)))];
let _e9634 = local_131;
let _e9636 = select(_e9615, _e9634, (_e9634 < _e9615));
let _e9641 = global_5.member[bitcast<u32>(select(0i, _e9636, (_e9636 > 0i)))];
let _e9642 = local_131;
let _e9645 = f32(_e934);
let _e9646 = f32(_e935);
let _e9653 = global_1.member.member_2.member;
let _e9654 = (((((f32(_e9604.member) + 0.5f) / _e9645) * 2f) - 1f) * _e9653);
let _e9661 = global_1.member.member_2.member_1;
let _e9662 = ((1f - (((f32(_e9604.member_1) + 0.5f) / _e9646) * 2f)) * _e9661);
let _e9664 = global_1.member.member_3;
let _e9672 = global_1.member.member_4;
let _e9679 = ((_e9664.member * _e9654) + (_e9672.member * _e9662));
let _e9680 = ((_e9664.member_1 * _e9654) + (_e9672.member_1 * _e9662));
let _e9681 = ((_e9664.member_2 * _e9654) + (_e9672.member_2 * _e9662));
let _e9684 = global_1.member.member_2.member_3;
let _e9685 = (_e9684 != 0u);
let _e9687 = global_1.member.member_5;
let _e9694 = select((_e9687.member + _e9679), _e9687.member, _e9685);
let _e9695 = select((_e9687.member_1 + _e9680), _e9687.member_1, _e9685);
let _e9696 = select((_e9687.member_2 + _e9681), _e9687.member_2, _e9685);
let _e9698 = global_1.member.member_6;
let _e9705 = select(_e9698.member, (_e9698.member + _e9679), _e9685);
let _e9706 = select(_e9698.member_1, (_e9698.member_1 + _e9680), _e9685);
let _e9707 = select(_e9698.member_2, (_e9698.member_2 + _e9681), _e9685);
let _e9712 = (((_e9694 * _e9694) + (_e9695 * _e9695)) + (_e9696 * _e9696));
let _e9715 = sqrt(select(0f, _e9712, (_e9712 > 0f)));
let _e9716 = (1f / _e9715);
let _e9717 = (_e9694 * _e9716);
let _e9718 = (_e9695 * _e9716);
let _e9719 = (_e9696 * _e9716);
let _e9720 = (_e574 - _e9705);
let _e9721 = (_e586 - _e9706);
let _e9722 = (_e599 - _e9707);
let _e9727 = (((_e9720 * _e9717) + (_e9721 * _e9718)) + (_e9722 * _e9719));
let _e9732 = (((_e9720 * _e612) + (_e9721 * _e625)) + (_e9722 * _e638));
let _e9737 = (((_e9717 * _e612) + (_e9718 * _e625)) + (_e9719 * _e638));
let _e9740 = ((_e9718 * _e638) - (_e9719 * _e625));
let _e9743 = ((_e9719 * _e612) - (_e9717 * _e638));
let _e9746 = ((_e9717 * _e625) - (_e9718 * _e612));
let _e9751 = (((_e9740 * _e9740) + (_e9743 * _e9743)) + (_e9746 * _e9746));
let _e9754 = (1f / select(1e-9f, _e9751, (_e9751 > 1e-9f)));
let _e9757 = ((_e9727 - (_e9737 * _e9732)) * _e9754);
let _e9760 = (((_e9737 * _e9727) - _e9732) * _e9754);
let _e9766 = -(_e9737);
let _e9769 = global_1.member.member_13.member_2;
let _e9770 = (_e9769 * _e9769);
let _e9774 = ((1f + _e9770) - ((2f * _e9769) * _e9766));
let _e9776 = select(1e-9f, _e9774, (_e9774 > 1e-9f));
let _e9788 = global_1.member.member_13.member_3;
let _e9796 = global_1.member.member_12.member_10;
let _e9799 = global_1.member.member_12.member_4;
let _e9802 = global_1.member.member_12.member_11;
let _e9808 = global_1.member.member.member;
let _e9810 = (_e9760 / _e690);
local_127 = bitcast<i32>((_e9796 + (_e9799 * _e9802)));
local_128 = _e280;
local_129 = bitcast<i32>(_e9808);
let _e9813 = global_1.member.member_13.member_6;
let _e9814 = f32(_e9813);
let _e9816 = select(0f, _e9810, (_e9810 > 0f));
let _e9819 = (select(1f, _e9816, (_e9816 < 1f)) * _e9814);
let _e9820 = (_e9814 - 1f);
let _e9822 = select(0f, _e9820, (_e9820 > 0f));
let _e9824 = select(0f, _e9819, (_e9819 > 0f));
let _e9826 = select(_e9822, _e9824, (_e9824 < _e9822));
let _e9833 = select(0i, select(select(i32(_e9826), i32(-2147483648), (_e9826 < -2147483600f)), 2147483647i, (_e9826 > 2147483500f)), (_e9826 == _e9826));
let _e9837 = (_e9833 - select(0i, 1i, (_e9826 < f32(_e9833))));
if (_e9837 > 0i) {
let _e9840 = local_127;
let _e9841 = local_129;
let _e9844 = local_128;
let _e9845 = ((_e9840 + ((_e9837 - 1i) * _e9841)) + _e9844);
let _e9847 = (bitcast<i32>(_e267) - 1i);
let _e9849 = select(_e9847, _e9845, (_e9845 < _e9847));
let _e9854 = global_7.member[bitcast<u32>(select(0i, _e9849, (_e9849 > 0i)))];
phi_22608_ = _e9854;
} else {
phi_22608_ = 0f;
}
let _e9856 = phi_22608_;
let _e9857 = local_127;
let _e9858 = local_129;
let _e9861 = local_128;
let _e9862 = ((_e9857 + (_e9837 * _e9858)) + _e9861);
let _e9864 = (bitcast<i32>(_e267) - 1i);
let _e9866 = select(_e9864, _e9862, (_e9862 < _e9864));
let _e9871 = global_7.member[bitcast<u32>(select(0i, _e9866, (_e9866 > 0i)))];
let _e9878 = (_e9633 - _e9622);
let _e9881 = ((_e9757 - _e9622) / select(1e-9f, _e9878, (_e9878 > 1e-9f)));
local_124 = 0i;
local_125 = _e9642;
local_126 = _e9608;
let _e9883 = select(0f, _e9881, (_e9881 > 0f));
let _e9886 = (select(1f, _e9883, (_e9883 < 1f)) * _e9814);
let _e9888 = select(0f, _e9886, (_e9886 > 0f));
let _e9890 = select(_e9822, _e9888, (_e9888 < _e9822));
let _e9897 = select(0i, select(select(i32(_e9890), i32(-2147483648), (_e9890 < -2147483600f)), 2147483647i, (_e9890 > 2147483500f)), (_e9890 == _e9890));
let _e9901 = (_e9897 - select(0i, 1i, (_e9890 < f32(_e9897))));
if (_e9901 > 0i) {
let _e9904 = local_124;
let _e9905 = local_126;
let _e9908 = local_125;
let _e9909 = ((_e9904 + ((_e9901 - 1i) * _e9905)) + _e9908);
let _e9911 = select(_e9864, _e9909, (_e9909 < _e9864));
let _e9916 = global_7.member[bitcast<u32>(select(0i, _e9911, (_e9911 > 0i)))];
phi_22735_ = _e9916;
} else {
phi_22735_ = 0f;
}
let _e9918 = phi_22735_;
let _e9919 = local_124;
let _e9920 = local_126;
let _e9923 = local_125;
let _e9924 = ((_e9919 + (_e9901 * _e9920)) + _e9923);
let _e9926 = select(_e9864, _e9924, (_e9924 < _e9864));
let _e9931 = global_7.member[bitcast<u32>(select(0i, _e9926, (_e9926 > 0i)))];
let _e9937 = ((_e9856 + ((_e9871 - _e9856) * (_e9819 - f32(_e9837)))) + (_e9918 + ((_e9931 - _e9918) * (_e9886 - f32(_e9901)))));
let _e9946 = global_1.member.member_13.member_7;
let _e9947 = bitcast<i32>(_e9946);
let _e9950 = global_1.member.member_13.member_8;
let _e9951 = bitcast<i32>(_e9950);
let _e9954 = global_1.member.member_13.member_9;
let _e9955 = bitcast<i32>(_e9954);
let _e9958 = global_1.member.member_13.member_4;
let _e9964 = global_1.member.member_13.member_5;
let _e9968 = f32(_e9947);
let _e9973 = (((((_e9705 + (_e9717 * _e9757)) - _e9958.member) / (_e9964.member - _e9958.member)) * _e9968) - 0.5f);
let _e9974 = (_e9968 - 1f);
let _e9976 = select(0f, _e9973, (_e9973 > 0f));
let _e9978 = select(_e9974, _e9976, (_e9976 < _e9974));
let _e9979 = f32(_e9951);
let _e9984 = (((((_e9706 + (_e9718 * _e9757)) - _e9958.member_1) / (_e9964.member_1 - _e9958.member_1)) * _e9979) - 0.5f);
let _e9985 = (_e9979 - 1f);
let _e9987 = select(0f, _e9984, (_e9984 > 0f));
let _e9989 = select(_e9985, _e9987, (_e9987 < _e9985));
let _e9990 = f32(_e9955);
let _e9995 = (((((_e9707 + (_e9719 * _e9757)) - _e9958.member_2) / (_e9964.member_2 - _e9958.member_2)) * _e9990) - 0.5f);
let _e9996 = (_e9990 - 1f);
let _e9998 = select(0f, _e9995, (_e9995 > 0f));
let _e10000 = select(_e9996, _e9998, (_e9998 < _e9996));
let _e10002 = select(0f, _e9978, (_e9978 > 0f));
let _e10004 = select(1e6f, _e10002, (_e10002 < 1e6f));
let _e10011 = select(0i, select(select(i32(_e10004), i32(-2147483648), (_e10004 < -2147483600f)), 2147483647i, (_e10004 > 2147483500f)), (_e10004 == _e10004));
let _e10015 = (_e10011 - select(0i, 1i, (_e10004 < f32(_e10011))));
let _e10017 = select(0f, _e9989, (_e9989 > 0f));
let _e10019 = select(1e6f, _e10017, (_e10017 < 1e6f));
let _e10026 = select(0i, select(select(i32(_e10019), i32(-2147483648), (_e10019 < -2147483600f)), 2147483647i, (_e10019 > 2147483500f)), (_e10019 == _e10019));
let _e10030 = (_e10026 - select(0i, 1i, (_e10019 < f32(_e10026))));
let _e10032 = select(0f, _e10000, (_e10000 > 0f));
let _e10034 = select(1e6f, _e10032, (_e10032 < 1e6f));
let _e10041 = select(0i, select(select(i32(_e10034), i32(-2147483648), (_e10034 < -2147483600f)), 2147483647i, (_e10034 > 2147483500f)), (_e10034 == _e10034));
let _e10045 = (_e10041 - select(0i, 1i, (_e10034 < f32(_e10041))));
let _e10049 = (_e9989 - f32(_e10030));
let _e10051 = (_e10000 - f32(_e10045));
local_122 = (_e9978 - f32(_e10015));
let _e10052 = (_e10015 + 1i);
let _e10054 = select(_e10052, 0i, (_e10052 < 0i));
if (_e10054 >= _e9947) {
phi_22883_ = (_e9947 - 1i);
} else {
phi_22883_ = _e10054;
}
let _e10058 = phi_22883_;
local_123 = (_e10058 - _e10015);
let _e10060 = (_e10030 + 1i);
let _e10062 = select(_e10060, 0i, (_e10060 < 0i));
if (_e10062 >= _e9951) {
phi_22896_ = (_e9951 - 1i);
} else {
phi_22896_ = _e10062;
}
let _e10066 = phi_22896_;
let _e10068 = ((_e10066 - _e10030) * _e9947);
let _e10069 = (_e10045 + 1i);
let _e10071 = select(_e10069, 0i, (_e10069 < 0i));
if (_e10071 >= _e9955) {
phi_22910_ = (_e9955 - 1i);
} else {
phi_22910_ = _e10071;
}
let _e10075 = phi_22910_;
let _e10081 = global_1.member.member_13.member_10;
let _e10087 = ((bitcast<i32>(_e10081) + (((_e10045 * _e9951) + _e10030) * _e9947)) + _e10015);
let _e10089 = (bitcast<i32>(_e264) - 1i);
let _e10091 = select(_e10089, _e10087, (_e10087 < _e10089));
let _e10096 = global_2.member[bitcast<u32>(select(0i, _e10091, (_e10091 > 0i)))];
let _e10097 = local_122;
let _e10100 = local_123;
let _e10101 = (_e10087 + _e10100);
let _e10103 = select(_e10089, _e10101, (_e10101 < _e10089));
let _e10108 = global_2.member[bitcast<u32>(select(0i, _e10103, (_e10103 > 0i)))];
let _e10109 = local_122;
let _e10112 = (1f - _e10049);
let _e10114 = (_e10087 + _e10068);
let _e10116 = select(_e10089, _e10114, (_e10114 < _e10089));
let _e10121 = global_2.member[bitcast<u32>(select(0i, _e10116, (_e10116 > 0i)))];
let _e10122 = local_122;
let _e10125 = local_123;
let _e10126 = (_e10114 + _e10125);
let _e10128 = select(_e10089, _e10126, (_e10126 < _e10089));
let _e10133 = global_2.member[bitcast<u32>(select(0i, _e10128, (_e10128 > 0i)))];
let _e10134 = local_122;
let _e10139 = (_e10087 + (((_e10075 - _e10045) * _e9947) * _e9951));
let _e10141 = select(_e10089, _e10139, (_e10139 < _e10089));
let _e10146 = global_2.member[bitcast<u32>(select(0i, _e10141, (_e10141 > 0i)))];
let _e10147 = local_122;
let _e10150 = local_123;
let _e10151 = (_e10139 + _e10150);
let _e10153 = select(_e10089, _e10151, (_e10151 < _e10089));
let _e10158 = global_2.member[bitcast<u32>(select(0i, _e10153, (_e10153 > 0i)))];
let _e10159 = local_122;
let _e10163 = (_e10139 + _e10068);
let _e10165 = select(_e10089, _e10163, (_e10163 < _e10089));
let _e10170 = global_2.member[bitcast<u32>(select(0i, _e10165, (_e10165 > 0i)))];
let _e10171 = local_122;
let _e10174 = local_123;
let _e10175 = (_e10163 + _e10174);
let _e10177 = select(_e10089, _e10175, (_e10175 < _e10089));
let _e10182 = global_2.member[bitcast<u32>(select(0i, _e10177, (_e10177 > 0i)))];
let _e10183 = local_122;
let _e10192 = ((_e9715 * (select(((1f - _e9770) / (_e9776 * sqrt(select(0f, _e9776, (_e9776 > 0f))))), (0.75f * (1f + (_e9766 * _e9766))), (_e9788 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e10096 * (1f - _e10097)) + (_e10108 * _e10109)) * _e10112) + (((_e10121 * (1f - _e10122)) + (_e10133 * _e10134)) * _e10049)) * (1f - _e10051)) + (((((_e10146 * (1f - _e10147)) + (_e10158 * _e10159)) * _e10112) + (((_e10170 * (1f - _e10171)) + (_e10182 * _e10183)) * _e10049)) * _e10051)));
let _e10195 = global_1.member.member_13.member_1;
let _e10204 = global_1.member.member_13.member;
let _e10209 = -((_e10204.member * _e9937));
let _e10211 = select(-87f, _e10209, (_e10209 > -87f));
let _e10213 = select(88f, _e10211, (_e10211 < 88f));
let _e10215 = ((_e10213 * 1.442695f) + 0.5f);
let _e10217 = select(-127f, _e10215, (_e10215 > -127f));
let _e10219 = select(128f, _e10217, (_e10217 < 128f));
let _e10226 = select(0i, select(select(i32(_e10219), i32(-2147483648), (_e10219 < -2147483600f)), 2147483647i, (_e10219 > 2147483500f)), (_e10219 == _e10219));
let _e10230 = (_e10226 - select(0i, 1i, (_e10219 < f32(_e10226))));
let _e10231 = f32(_e10230);
let _e10235 = ((_e10213 - (_e10231 * 0.6933594f)) - (_e10231 * -2.1219444e-4f));
let _e10257 = -((_e10204.member_1 * _e9937));
let _e10259 = select(-87f, _e10257, (_e10257 > -87f));
let _e10261 = select(88f, _e10259, (_e10259 < 88f));
let _e10263 = ((_e10261 * 1.442695f) + 0.5f);
let _e10265 = select(-127f, _e10263, (_e10263 > -127f));
let _e10267 = select(128f, _e10265, (_e10265 < 128f));
let _e10274 = select(0i, select(select(i32(_e10267), i32(-2147483648), (_e10267 < -2147483600f)), 2147483647i, (_e10267 > 2147483500f)), (_e10267 == _e10267));
let _e10278 = (_e10274 - select(0i, 1i, (_e10267 < f32(_e10274))));
let _e10279 = f32(_e10278);
let _e10283 = ((_e10261 - (_e10279 * 0.6933594f)) - (_e10279 * -2.1219444e-4f));
let _e10305 = -((_e10204.member_2 * _e9937));
let _e10307 = select(-87f, _e10305, (_e10305 > -87f));
let _e10309 = select(88f, _e10307, (_e10307 < 88f));
let _e10311 = ((_e10309 * 1.442695f) + 0.5f);
let _e10313 = select(-127f, _e10311, (_e10311 > -127f));
let _e10315 = select(128f, _e10313, (_e10313 < 128f));
let _e10322 = select(0i, select(select(i32(_e10315), i32(-2147483648), (_e10315 < -2147483600f)), 2147483647i, (_e10315 > 2147483500f)), (_e10315 == _e10315));
let _e10326 = (_e10322 - select(0i, 1i, (_e10315 < f32(_e10322))));
let _e10327 = f32(_e10326);
let _e10331 = ((_e10309 - (_e10327 * 0.6933594f)) - (_e10327 * -2.1219444e-4f));
let _e10358 = select(0f, _e9757, (((_e9760 >= 0f) && (_e9760 < _e690)) && (_e9757 > 0f)));
let _e10360 = ((_e765 + _e8333) + _e8337);
let _e10361 = (_e10360 & 31u);
let _e10363 = (1u << bitcast<u32>(_e10361));
let _e10372 = bitcast<i32>((((_e930 + _e10363) - 1u) >> bitcast<u32>(_e10361)));
let _e10373 = bitcast<i32>((((_e933 + _e10363) - 1u) >> bitcast<u32>(_e10361)));
if _e452 {
phi_23371_ = type_23(_e10373, _e10372);
} else {
phi_23371_ = type_23(_e10372, _e10373);
}
let _e10377 = phi_23371_;
let _e10382 = f32((1i << bitcast<u32>(_e10361)));
let _e10383 = (1f / _e10382);
let _e10385 = ((_e9459 * _e10383) - 0.5f);
let _e10387 = ((_e9553 * _e10383) - 0.5f);
let _e10389 = select(-1f, _e10385, (_e10385 > -1f));
let _e10391 = select(1e6f, _e10389, (_e10389 < 1e6f));
let _e10398 = select(0i, select(select(i32(_e10391), i32(-2147483648), (_e10391 < -2147483600f)), 2147483647i, (_e10391 > 2147483500f)), (_e10391 == _e10391));
let _e10402 = (_e10398 - select(0i, 1i, (_e10391 < f32(_e10398))));
let _e10404 = select(-1f, _e10387, (_e10387 > -1f));
let _e10406 = select(1e6f, _e10404, (_e10404 < 1e6f));
let _e10413 = select(0i, select(select(i32(_e10406), i32(-2147483648), (_e10406 < -2147483600f)), 2147483647i, (_e10406 > 2147483500f)), (_e10406 == _e10406));
let _e10417 = (_e10413 - select(0i, 1i, (_e10406 < f32(_e10413))));
let _e10419 = (_e10385 - f32(_e10402));
let _e10421 = (_e10387 - f32(_e10417));
let _e10422 = (1f - _e10419);
let _e10423 = (1f - _e10421);
let _e10426 = select(_e10402, 0i, (_e10402 < 0i));
let _e10427 = (_e10426 >= _e10377.member);
if _e10427 {
phi_23449_ = (_e10377.member - 1i);
} else {
phi_23449_ = _e10426;
}
let _e10430 = phi_23449_;
let _e10432 = select(_e10417, 0i, (_e10417 < 0i));
let _e10433 = (_e10432 >= _e10377.member_1);
if _e10433 {
phi_23460_ = (_e10377.member_1 - 1i);
} else {
phi_23460_ = _e10432;
}
let _e10436 = phi_23460_;
let _e10440 = (((f32(_e10430) + 0.5f) * _e10382) - 0.5f);
let _e10444 = (((f32(_e10436) + 0.5f) * _e10382) - 0.5f);
if _e452 {
phi_23488_ = type_23(_e10436, _e10430);
} else {
phi_23488_ = type_23(_e10430, _e10436);
}
let _e10450 = phi_23488_;
let _e10456 = bitcast<i32>(((_e930 + 1u) >> bitcast<u32>(1u)));
let _e10459 = global_1.member.member_18.member_6;
let _e10462 = global_1.member.member_18.member_7;
let _e10465 = global_1.member.member_18.member_8;
let _e10466 = (_e10360 == 0u);
if _e10466 {
phi_23539_ = 0u;
} else {
if (_e10360 == 1u) {
phi_23538_ = 0u;
} else {
if (_e10360 == 2u) {
phi_23537_ = _e10459;
} else {
phi_23537_ = select(_e10465, _e10462, (_e10360 == 3u));
}
let _e10472 = phi_23537_;
phi_23538_ = _e10472;
}
let _e10474 = phi_23538_;
phi_23539_ = _e10474;
}
let _e10476 = phi_23539_;
local_120 = (((bitcast<i32>(_e10476) + _e10450.member_1) * _e10456) + _e10450.member);
let _e10481 = local_120;
let _e10483 = (bitcast<i32>(_e261) - 1i);
let _e10485 = select(_e10483, _e10481, (_e10481 < _e10483));
let _e10490 = global_6.member[bitcast<u32>(select(0i, _e10485, (_e10485 > 0i)))];
let _e10495 = (((((select(_e10440, _e10444, _e452) + 0.5f) / _e9645) * 2f) - 1f) * _e9653);
let _e10500 = ((1f - (((select(_e10444, _e10440, _e452) + 0.5f) / _e9646) * 2f)) * _e9661);
let _e10507 = ((_e9664.member * _e10495) + (_e9672.member * _e10500));
let _e10508 = ((_e9664.member_1 * _e10495) + (_e9672.member_1 * _e10500));
let _e10509 = ((_e9664.member_2 * _e10495) + (_e9672.member_2 * _e10500));
let _e10513 = select((_e9687.member + _e10507), _e9687.member, _e9685);
let _e10514 = select((_e9687.member_1 + _e10508), _e9687.member_1, _e9685);
let _e10515 = select((_e9687.member_2 + _e10509), _e9687.member_2, _e9685);
let _e10526 = (((_e10513 * _e10513) + (_e10514 * _e10514)) + (_e10515 * _e10515));
let _e10530 = (1f / sqrt(select(0f, _e10526, (_e10526 > 0f))));
let _e10531 = (_e10513 * _e10530);
let _e10532 = (_e10514 * _e10530);
let _e10533 = (_e10515 * _e10530);
let _e10534 = (_e574 - select(_e9698.member, (_e9698.member + _e10507), _e9685));
let _e10535 = (_e586 - select(_e9698.member_1, (_e9698.member_1 + _e10508), _e9685));
let _e10536 = (_e599 - select(_e9698.member_2, (_e9698.member_2 + _e10509), _e9685));
let _e10541 = (((_e10534 * _e10531) + (_e10535 * _e10532)) + (_e10536 * _e10533));
let _e10546 = (((_e10534 * _e612) + (_e10535 * _e625)) + (_e10536 * _e638));
let _e10551 = (((_e10531 * _e612) + (_e10532 * _e625)) + (_e10533 * _e638));
let _e10554 = ((_e10532 * _e638) - (_e10533 * _e625));
let _e10557 = ((_e10533 * _e612) - (_e10531 * _e638));
let _e10560 = ((_e10531 * _e625) - (_e10532 * _e612));
let _e10565 = (((_e10554 * _e10554) + (_e10557 * _e10557)) + (_e10560 * _e10560));
let _e10568 = (1f / select(1e-9f, _e10565, (_e10565 > 1e-9f)));
let _e10571 = ((_e10541 - (_e10551 * _e10546)) * _e10568);
let _e10574 = (((_e10551 * _e10541) - _e10546) * _e10568);
let _e10580 = select(0f, _e10571, (((_e10574 >= 0f) && (_e10574 < _e690)) && (_e10571 > 0f)));
let _e10582 = (_e10430 << bitcast<u32>(_e10361));
let _e10594 = (_e10402 + 1i);
let _e10597 = select(_e10594, 0i, (_e10594 < 0i));
let _e10598 = (_e10597 >= _e10377.member);
if _e10598 {
phi_24086_ = (_e10377.member - 1i);
} else {
phi_24086_ = _e10597;
}
let _e10601 = phi_24086_;
if _e10433 {
phi_24097_ = (_e10377.member_1 - 1i);
} else {
phi_24097_ = _e10432;
}
let _e10604 = phi_24097_;
let _e10608 = (((f32(_e10601) + 0.5f) * _e10382) - 0.5f);
let _e10612 = (((f32(_e10604) + 0.5f) * _e10382) - 0.5f);
if _e452 {
phi_24125_ = type_23(_e10604, _e10601);
} else {
phi_24125_ = type_23(_e10601, _e10604);
}
let _e10618 = phi_24125_;
if _e10466 {
phi_24176_ = 0u;
} else {
if (_e10360 == 1u) {
phi_24175_ = 0u;
} else {
if (_e10360 == 2u) {
phi_24174_ = _e10459;
} else {
phi_24174_ = select(_e10465, _e10462, (_e10360 == 3u));
}
let _e10626 = phi_24174_;
phi_24175_ = _e10626;
}
let _e10628 = phi_24175_;
phi_24176_ = _e10628;
}
let _e10630 = phi_24176_;
local_118 = (((bitcast<i32>(_e10630) + _e10618.member_1) * _e10456) + _e10618.member);
let _e10635 = local_118;
let _e10637 = select(_e10483, _e10635, (_e10635 < _e10483));
let _e10642 = global_6.member[bitcast<u32>(select(0i, _e10637, (_e10637 > 0i)))];
let _e10647 = (((((select(_e10608, _e10612, _e452) + 0.5f) / _e9645) * 2f) - 1f) * _e9653);
let _e10652 = ((1f - (((select(_e10612, _e10608, _e452) + 0.5f) / _e9646) * 2f)) * _e9661);
let _e10659 = ((_e9664.member * _e10647) + (_e9672.member * _e10652));
let _e10660 = ((_e9664.member_1 * _e10647) + (_e9672.member_1 * _e10652));
let _e10661 = ((_e9664.member_2 * _e10647) + (_e9672.member_2 * _e10652));
let _e10665 = select((_e9687.member + _e10659), _e9687.member, _e9685);
let _e10666 = select((_e9687.member_1 + _e10660), _e9687.member_1, _e9685);
let _e10667 = select((_e9687.member_2 + _e10661), _e9687.member_2, _e9685);
let _e10678 = (((_e10665 * _e10665) + (_e10666 * _e10666)) + (_e10667 * _e10667));
let _e10682 = (1f / sqrt(select(0f, _e10678, (_e10678 > 0f))));
let _e10683 = (_e10665 * _e10682);
let _e10684 = (_e10666 * _e10682);
let _e10685 = (_e10667 * _e10682);
let _e10686 = (_e574 - select(_e9698.member, (_e9698.member + _e10659), _e9685));
let _e10687 = (_e586 - select(_e9698.member_1, (_e9698.member_1 + _e10660), _e9685));
let _e10688 = (_e599 - select(_e9698.member_2, (_e9698.member_2 + _e10661), _e9685));
let _e10693 = (((_e10686 * _e10683) + (_e10687 * _e10684)) + (_e10688 * _e10685));
let _e10698 = (((_e10686 * _e612) + (_e10687 * _e625)) + (_e10688 * _e638));
let _e10703 = (((_e10683 * _e612) + (_e10684 * _e625)) + (_e10685 * _e638));
let _e10706 = ((_e10684 * _e638) - (_e10685 * _e625));
let _e10709 = ((_e10685 * _e612) - (_e10683 * _e638));
let _e10712 = ((_e10683 * _e625) - (_e10684 * _e612));
let _e10717 = (((_e10706 * _e10706) + (_e10709 * _e10709)) + (_e10712 * _e10712));
let _e10720 = (1f / select(1e-9f, _e10717, (_e10717 > 1e-9f)));
let _e10723 = ((_e10693 - (_e10703 * _e10698)) * _e10720);
let _e10726 = (((_e10703 * _e10693) - _e10698) * _e10720);
let _e10732 = select(0f, _e10723, (((_e10726 >= 0f) && (_e10726 < _e690)) && (_e10723 > 0f)));
let _e10734 = (_e10601 << bitcast<u32>(_e10361));
let _e10746 = (_e10417 + 1i);
if _e10427 {
phi_24723_ = (_e10377.member - 1i);
} else {
phi_24723_ = _e10426;
}
let _e10750 = phi_24723_;
let _e10752 = select(_e10746, 0i, (_e10746 < 0i));
let _e10753 = (_e10752 >= _e10377.member_1);
if _e10753 {
phi_24734_ = (_e10377.member_1 - 1i);
} else {
phi_24734_ = _e10752;
}
let _e10756 = phi_24734_;
let _e10760 = (((f32(_e10750) + 0.5f) * _e10382) - 0.5f);
let _e10764 = (((f32(_e10756) + 0.5f) * _e10382) - 0.5f);
if _e452 {
phi_24762_ = type_23(_e10756, _e10750);
} else {
phi_24762_ = type_23(_e10750, _e10756);
}
let _e10770 = phi_24762_;
if _e10466 {
phi_24813_ = 0u;
} else {
if (_e10360 == 1u) {
phi_24812_ = 0u;
} else {
if (_e10360 == 2u) {
phi_24811_ = _e10459;
} else {
phi_24811_ = select(_e10465, _e10462, (_e10360 == 3u));
}
let _e10778 = phi_24811_;
phi_24812_ = _e10778;
}
let _e10780 = phi_24812_;
phi_24813_ = _e10780;
}
let _e10782 = phi_24813_;
local_116 = (((bitcast<i32>(_e10782) + _e10770.member_1) * _e10456) + _e10770.member);
let _e10787 = local_116;
let _e10789 = select(_e10483, _e10787, (_e10787 < _e10483));
let _e10794 = global_6.member[bitcast<u32>(select(0i, _e10789, (_e10789 > 0i)))];
let _e10799 = (((((select(_e10760, _e10764, _e452) + 0.5f) / _e9645) * 2f) - 1f) * _e9653);
let _e10804 = ((1f - (((select(_e10764, _e10760, _e452) + 0.5f) / _e9646) * 2f)) * _e9661);
let _e10811 = ((_e9664.member * _e10799) + (_e9672.member * _e10804));
let _e10812 = ((_e9664.member_1 * _e10799) + (_e9672.member_1 * _e10804));
let _e10813 = ((_e9664.member_2 * _e10799) + (_e9672.member_2 * _e10804));
let _e10817 = select((_e9687.member + _e10811), _e9687.member, _e9685);
let _e10818 = select((_e9687.member_1 + _e10812), _e9687.member_1, _e9685);
let _e10819 = select((_e9687.member_2 + _e10813), _e9687.member_2, _e9685);
let _e10830 = (((_e10817 * _e10817) + (_e10818 * _e10818)) + (_e10819 * _e10819));
let _e10834 = (1f / sqrt(select(0f, _e10830, (_e10830 > 0f))));
let _e10835 = (_e10817 * _e10834);
let _e10836 = (_e10818 * _e10834);
let _e10837 = (_e10819 * _e10834);
let _e10838 = (_e574 - select(_e9698.member, (_e9698.member + _e10811), _e9685));
let _e10839 = (_e586 - select(_e9698.member_1, (_e9698.member_1 + _e10812), _e9685));
let _e10840 = (_e599 - select(_e9698.member_2, (_e9698.member_2 + _e10813), _e9685));
let _e10845 = (((_e10838 * _e10835) + (_e10839 * _e10836)) + (_e10840 * _e10837));
let _e10850 = (((_e10838 * _e612) + (_e10839 * _e625)) + (_e10840 * _e638));
let _e10855 = (((_e10835 * _e612) + (_e10836 * _e625)) + (_e10837 * _e638));
let _e10858 = ((_e10836 * _e638) - (_e10837 * _e625));
let _e10861 = ((_e10837 * _e612) - (_e10835 * _e638));
let _e10864 = ((_e10835 * _e625) - (_e10836 * _e612));
let _e10869 = (((_e10858 * _e10858) + (_e10861 * _e10861)) + (_e10864 * _e10864));
let _e10872 = (1f / select(1e-9f, _e10869, (_e10869 > 1e-9f)));
let _e10875 = ((_e10845 - (_e10855 * _e10850)) * _e10872);
let _e10878 = (((_e10855 * _e10845) - _e10850) * _e10872);
let _e10884 = select(0f, _e10875, (((_e10878 >= 0f) && (_e10878 < _e690)) && (_e10875 > 0f)));
let _e10886 = (_e10750 << bitcast<u32>(_e10361));
if _e10598 {
phi_25360_ = (_e10377.member - 1i);
} else {
phi_25360_ = _e10597;
}
let _e10901 = phi_25360_;
if _e10753 {
phi_25371_ = (_e10377.member_1 - 1i);
} else {
phi_25371_ = _e10752;
}
let _e10904 = phi_25371_;
let _e10908 = (((f32(_e10901) + 0.5f) * _e10382) - 0.5f);
let _e10912 = (((f32(_e10904) + 0.5f) * _e10382) - 0.5f);
if _e452 {
phi_25399_ = type_23(_e10904, _e10901);
} else {
phi_25399_ = type_23(_e10901, _e10904);
}
let _e10918 = phi_25399_;
if _e10466 {
phi_25450_ = 0u;
} else {
if (_e10360 == 1u) {
phi_25449_ = 0u;
} else {
if (_e10360 == 2u) {
phi_25448_ = _e10459;
} else {
phi_25448_ = select(_e10465, _e10462, (_e10360 == 3u));
}
let _e10926 = phi_25448_;
phi_25449_ = _e10926;
}
let _e10928 = phi_25449_;
phi_25450_ = _e10928;
}
let _e10930 = phi_25450_;
local_114 = (((bitcast<i32>(_e10930) + _e10918.member_1) * _e10456) + _e10918.member);
let _e10935 = local_114;
let _e10937 = select(_e10483, _e10935, (_e10935 < _e10483));
let _e10942 = global_6.member[bitcast<u32>(select(0i, _e10937, (_e10937 > 0i)))];
let _e10947 = (((((select(_e10908, _e10912, _e452) + 0.5f) / _e9645) * 2f) - 1f) * _e9653);
let _e10952 = ((1f - (((select(_e10912, _e10908, _e452) + 0.5f) / _e9646) * 2f)) * _e9661);
let _e10959 = ((_e9664.member * _e10947) + (_e9672.member * _e10952));
let _e10960 = ((_e9664.member_1 * _e10947) + (_e9672.member_1 * _e10952));
let _e10961 = ((_e9664.member_2 * _e10947) + (_e9672.member_2 * _e10952));
let _e10965 = select((_e9687.member + _e10959), _e9687.member, _e9685);
let _e10966 = select((_e9687.member_1 + _e10960), _e9687.member_1, _e9685);
let _e10967 = select((_e9687.member_2 + _e10961), _e9687.member_2, _e9685);
let _e10978 = (((_e10965 * _e10965) + (_e10966 * _e10966)) + (_e10967 * _e10967));
let _e10982 = (1f / sqrt(select(0f, _e10978, (_e10978 > 0f))));
let _e10983 = (_e10965 * _e10982);
let _e10984 = (_e10966 * _e10982);
let _e10985 = (_e10967 * _e10982);
let _e10986 = (_e574 - select(_e9698.member, (_e9698.member + _e10959), _e9685));
let _e10987 = (_e586 - select(_e9698.member_1, (_e9698.member_1 + _e10960), _e9685));
let _e10988 = (_e599 - select(_e9698.member_2, (_e9698.member_2 + _e10961), _e9685));
let _e10993 = (((_e10986 * _e10983) + (_e10987 * _e10984)) + (_e10988 * _e10985));
let _e10998 = (((_e10986 * _e612) + (_e10987 * _e625)) + (_e10988 * _e638));
let _e11003 = (((_e10983 * _e612) + (_e10984 * _e625)) + (_e10985 * _e638));
let _e11006 = ((_e10984 * _e638) - (_e10985 * _e625));
let _e11009 = ((_e10985 * _e612) - (_e10983 * _e638));
let _e11012 = ((_e10983 * _e625) - (_e10984 * _e612));
let _e11017 = (((_e11006 * _e11006) + (_e11009 * _e11009)) + (_e11012 * _e11012));
let _e11020 = (1f / select(1e-9f, _e11017, (_e11017 > 1e-9f)));
let _e11023 = ((_e10993 - (_e11003 * _e10998)) * _e11020);
let _e11026 = (((_e11003 * _e10993) - _e10998) * _e11020);
let _e11032 = select(0f, _e11023, (((_e11026 >= 0f) && (_e11026 < _e690)) && (_e11023 > 0f)));
let _e11034 = (_e10901 << bitcast<u32>(_e10361));
let _e11046 = select(((((1f - select(0f, (_e10422 * _e10423), (((select(select(_e765, _e926, (_e10582 >= _e691)), _e846, (_e10582 < _e297)) == _e10360) && (_e10580 > 0f)) && (_e10580 < _e10490)))) - select(0f, (_e10419 * _e10423), (((select(select(_e765, _e926, (_e10734 >= _e691)), _e846, (_e10734 < _e297)) == _e10360) && (_e10732 > 0f)) && (_e10732 < _e10642)))) - select(0f, (_e10422 * _e10421), (((select(select(_e765, _e926, (_e10886 >= _e691)), _e846, (_e10886 < _e297)) == _e10360) && (_e10884 > 0f)) && (_e10884 < _e10794)))) - select(0f, (_e10419 * _e10421), (((select(select(_e765, _e926, (_e11034 >= _e691)), _e846, (_e11034 < _e297)) == _e10360) && (_e11032 > 0f)) && (_e11032 < _e10942)))), 1f, _e10466);
if _e452 {
phi_26006_ = type_23(_e9550, _e9457);
} else {
phi_26006_ = type_23(_e9457, _e9550);
}
let _e11061 = phi_26006_;
let _e11064 = (_e9551 && (((_e10358 > 0f) && (_e10358 < _e9641)) && (bitcast<f32>((bitcast<u32>(_e11046) & 2147483647u)) > 1e-6f)));
let _e11067 = global_1.member.member_18.member;
let _e11068 = (((select(_e9576, (1f - _e9576), (_e9561 >= 0f)) - select(_e9595, (1f - _e9595), (_e9580 >= 0f))) * (1f / _e9558)) * _e11067);
let _e11072 = select(0f, (((((_e651 * _e10195.member) * ((1f + (_e10235 * (1f + (_e10235 * (0.5f + (_e10235 * (0.16666667f + (_e10235 * (0.041666668f + (_e10235 * (0.008333334f + (_e10235 * (0.001388889f + (_e10235 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10230 + 127i)) << bitcast<u32>(23i))))) * _e10192) * _e11046) * _e11068), _e11064);
let _e11073 = select(0f, (((((_e664 * _e10195.member_1) * ((1f + (_e10283 * (1f + (_e10283 * (0.5f + (_e10283 * (0.16666667f + (_e10283 * (0.041666668f + (_e10283 * (0.008333334f + (_e10283 * (0.001388889f + (_e10283 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10278 + 127i)) << bitcast<u32>(23i))))) * _e10192) * _e11046) * _e11068), _e11064);
let _e11074 = select(0f, (((((_e677 * _e10195.member_2) * ((1f + (_e10331 * (1f + (_e10331 * (0.5f + (_e10331 * (0.16666667f + (_e10331 * (0.041666668f + (_e10331 * (0.008333334f + (_e10331 * (0.001388889f + (_e10331 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e10326 + 127i)) << bitcast<u32>(23i))))) * _e10192) * _e11046) * _e11068), _e11064);
let _e11078 = (bitcast<f32>((bitcast<u32>(_e11072) & 2147483647u)) >= 1073741800f);
let _e11079 = (1f / 1048576f);
let _e11082 = ((_e11072 * select(1f, _e11079, _e11078)) + 0.5f);
let _e11084 = select(-1073741800f, _e11082, (_e11082 > -1073741800f));
let _e11086 = select(1073741800f, _e11084, (_e11084 < 1073741800f));
let _e11093 = select(0i, select(select(i32(_e11086), i32(-2147483648), (_e11086 < -2147483600f)), 2147483647i, (_e11086 > 2147483500f)), (_e11086 == _e11086));
let _e11097 = (_e11093 - select(0i, 1i, (_e11086 < f32(_e11093))));
let _e11098 = select(0i, 20i, _e11078);
let _e11102 = (bitcast<u32>(_e11097) << bitcast<u32>((_e11098 & 31i)));
let _e11109 = bitcast<u32>(((_e11097 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11098) & 31i))));
let _e11113 = (bitcast<f32>((bitcast<u32>(_e11073) & 2147483647u)) >= 1073741800f);
let _e11116 = ((_e11073 * select(1f, _e11079, _e11113)) + 0.5f);
let _e11118 = select(-1073741800f, _e11116, (_e11116 > -1073741800f));
let _e11120 = select(1073741800f, _e11118, (_e11118 < 1073741800f));
let _e11127 = select(0i, select(select(i32(_e11120), i32(-2147483648), (_e11120 < -2147483600f)), 2147483647i, (_e11120 > 2147483500f)), (_e11120 == _e11120));
let _e11131 = (_e11127 - select(0i, 1i, (_e11120 < f32(_e11127))));
let _e11132 = select(0i, 20i, _e11113);
let _e11136 = (bitcast<u32>(_e11131) << bitcast<u32>((_e11132 & 31i)));
let _e11143 = bitcast<u32>(((_e11131 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11132) & 31i))));
let _e11147 = (bitcast<f32>((bitcast<u32>(_e11074) & 2147483647u)) >= 1073741800f);
let _e11150 = ((_e11074 * select(1f, _e11079, _e11147)) + 0.5f);
let _e11152 = select(-1073741800f, _e11150, (_e11150 > -1073741800f));
let _e11154 = select(1073741800f, _e11152, (_e11152 < 1073741800f));
let _e11161 = select(0i, select(select(i32(_e11154), i32(-2147483648), (_e11154 < -2147483600f)), 2147483647i, (_e11154 > 2147483500f)), (_e11154 == _e11154));
let _e11165 = (_e11161 - select(0i, 1i, (_e11154 < f32(_e11161))));
let _e11166 = select(0i, 20i, _e11147);
let _e11170 = (bitcast<u32>(_e11165) << bitcast<u32>((_e11166 & 31i)));
let _e11177 = bitcast<u32>(((_e11165 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e11166) & 31i))));
let _e11182 = bitcast<i32>(bitcast<u32>((((_e11061.member_1 * _e934) + _e11061.member) * 6i)));
if ((_e11102 | _e11109) == 0u) {
} else {
let _e11185 = bitcast<u32>(_e11182);
if (_e11185 < _e269) {
let _e11189 = atomicAdd((&global_8.member[_e11185]), _e11102);
phi_26239_ = _e11189;
} else {
phi_26239_ = 0u;
}
let _e11191 = phi_26239_;
let _e11195 = (_e11109 + select(0u, 1u, ((_e11191 + _e11102) < _e11102)));
if (_e11195 == 0u) {
} else {
let _e11197 = (_e11185 + 1u);
if (_e11197 < _e269) {
let _e11201 = atomicAdd((&global_8.member[_e11197]), _e11195);
}
}
}
if ((_e11136 | _e11143) == 0u) {
} else {
let _e11205 = bitcast<u32>((_e11182 + 2i));
if (_e11205 < _e269) {
let _e11209 = atomicAdd((&global_8.member[_e11205]), _e11136);
phi_26269_ = _e11209;
} else {
phi_26269_ = 0u;
}
let _e11211 = phi_26269_;
let _e11215 = (_e11143 + select(0u, 1u, ((_e11211 + _e11136) < _e11136)));
if (_e11215 == 0u) {
} else {
let _e11217 = (_e11205 + 1u);
if (_e11217 < _e269) {
let _e11221 = atomicAdd((&global_8.member[_e11217]), _e11215);
}
}
}
if ((_e11170 | _e11177) == 0u) {
} else {
let _e11225 = bitcast<u32>((_e11182 + 4i));
if (_e11225 < _e269) {
let _e11229 = atomicAdd((&global_8.member[_e11225]), _e11170);
phi_26299_ = _e11229;
} else {
phi_26299_ = 0u;
}
let _e11231 = phi_26299_;
let _e11235 = (_e11177 + select(0u, 1u, ((_e11231 + _e11170) < _e11170)));
if (_e11235 == 0u) {
} else {
let _e11237 = (_e11225 + 1u);
if (_e11237 < _e269) {
let _e11241 = atomicAdd((&global_8.member[_e11237]), _e11235);
}
}
}
phi_22091_ = (_e9548 + 1i);
} else {
phi_22091_ = i32();
}
let _e11244 = phi_22091_;
continue;
continuing {
phi_22090_ = _e11244;
break if !(_e9551);
}
}
phi_21937_ = (_e9454 + 1i);
} else {
phi_21937_ = i32();
}
let _e11248 = phi_21937_;
continue;
continuing {
phi_21936_ = _e11248;
break if !(_e9455);
}
}
} else {
phi_26344_ = 0i;
loop {
let _e11251 = phi_26344_;
let _e11252 = (_e11251 < 16i);
if _e11252 {
let _e11254 = (_e979 + (_e11251 & 15i));
let _e11256 = (f32(_e11254) + 0.5f);
let _e11258 = ((_e11256 * 1f) - 0.5f);
let _e11262 = (-(((_e415 * _e11258) + _e441)) / _e428);
let _e11269 = bitcast<f32>((bitcast<u32>(((_e465 * _e11258) + ((_e478 * _e11262) + _e491))) & 2147483647u));
let _e11276 = bitcast<f32>((bitcast<u32>(((_e504 * _e11258) + ((_e517 * _e11262) + _e530))) & 2147483647u));
let _e11280 = (((0.5f * (_e11269 + _e11276)) / _e533) + _e716);
let _e11281 = (1f / 1f);
let _e11289 = ((((_e11262 + _e11280) + 0.5f) * _e11281) - 0.5f);
let _e11290 = f32(_e8331);
let _e11291 = f32(_e8329);
let _e11292 = (_e11290 - 1f);
let _e11294 = select(_e11292, _e11289, (_e11289 > _e11292));
let _e11296 = select(_e11291, _e11294, (_e11294 < _e11291));
let _e11303 = select(0i, select(select(i32(_e11296), i32(-2147483648), (_e11296 < -2147483600f)), 2147483647i, (_e11296 > 2147483500f)), (_e11296 == _e11296));
let _e11308 = (((((_e11262 - _e11280) + 0.5f) * _e11281) - 0.5f) + 1f);
let _e11309 = (_e11291 + 1f);
let _e11311 = select(_e11290, _e11308, (_e11308 > _e11290));
let _e11313 = select(_e11309, _e11311, (_e11311 < _e11309));
let _e11320 = select(0i, select(select(i32(_e11313), i32(-2147483648), (_e11313 < -2147483600f)), 2147483647i, (_e11313 > 2147483500f)), (_e11313 == _e11313));
let _e11331 = ((1e-4f * 1f) * _e533);
let _e11333 = select(_e11276, _e11269, (_e11269 > _e11276));
let _e11335 = select(_e11331, _e11333, (_e11333 > _e11331));
let _e11337 = select(_e11276, _e11269, (_e11269 < _e11276));
let _e11339 = select(_e11331, _e11337, (_e11337 > _e11331));
let _e11341 = (0.5f * (_e11335 + _e11339));
let _e11342 = (0.5f / _e11339);
let _e11343 = (1f / _e11335);
phi_26498_ = 0i;
loop {
let _e11345 = phi_26498_;
let _e11347 = (((_e11320 - select(0i, 1i, (_e11313 < f32(_e11320)))) + (_e11251 >> bitcast<u32>(4u))) + bitcast<i32>(_e11345));
let _e11348 = (_e11347 <= select(-1i, (_e11303 - select(0i, 1i, (_e11296 < f32(_e11303)))), (_e11254 <= _e983)));
if _e11348 {
let _e11350 = (f32(_e11347) + 0.5f);
let _e11354 = ((((_e11350 * 1f) - 0.5f) - _e11262) * _e533);
let _e11355 = (_e533 * 1f);
let _e11357 = (0.5f * _e11355);
let _e11358 = (_e11354 + _e11357);
let _e11359 = -(_e11358);
let _e11362 = (_e11341 - select(_e11359, _e11358, (_e11358 > _e11359)));
let _e11364 = select(0f, _e11362, (_e11362 > 0f));
let _e11366 = select(_e11339, _e11364, (_e11364 < _e11339));
let _e11369 = (_e11362 - _e11339);
let _e11373 = (((_e11366 * (_e11366 * _e11342)) + select(0f, _e11369, (_e11369 > 0f))) * _e11343);
let _e11377 = (_e11354 - _e11357);
let _e11378 = -(_e11377);
let _e11381 = (_e11341 - select(_e11378, _e11377, (_e11377 > _e11378)));
let _e11383 = select(0f, _e11381, (_e11381 > 0f));
let _e11385 = select(_e11339, _e11383, (_e11383 < _e11339));
let _e11388 = (_e11381 - _e11339);
let _e11392 = (((_e11385 * (_e11385 * _e11342)) + select(0f, _e11388, (_e11388 > 0f))) * _e11343);
if _e452 {
phi_26603_ = type_23(_e11347, _e11254);
} else {
phi_26603_ = type_23(_e11254, _e11347);
}
let _e11401 = phi_26603_;
let _e11405 = bitcast<i32>((_e930 * _e933));
local_112 = _e11405;
local_113 = ((_e11401.member_1 * _e934) + _e11401.member);
let _e11408 = local_112;
let _e11409 = local_113;
let _e11410 = (_e11408 + _e11409);
let _e11412 = (bitcast<i32>(_e258) - 1i);
let _e11414 = select(_e11412, _e11410, (_e11410 < _e11412));
let _e11419 = global_5.member[bitcast<u32>(select(0i, _e11414, (_e11414 > 0i)))];
let _e11420 = local_112;
let _e11422 = local_113;
let _e11423 = ((2i * _e11420) + _e11422);
let _e11425 = select(_e11412, _e11423, (_e11423 < _e11412));
let _e11430 = global_5.member[bitcast<u32>(select(0i, _e11425, (_e11425 > 0i)))];
let _e11431 = local_113;
let _e11433 = select(_e11412, _e11431, (_e11431 < _e11412));
let _e11438 = global_5.member[bitcast<u32>(select(0i, _e11433, (_e11433 > 0i)))];
let _e11439 = local_113;
let _e11442 = f32(_e934);
let _e11443 = f32(_e935);
let _e11450 = global_1.member.member_2.member;
let _e11451 = (((((f32(_e11401.member) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e11458 = global_1.member.member_2.member_1;
let _e11459 = ((1f - (((f32(_e11401.member_1) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e11461 = global_1.member.member_3;
let _e11469 = global_1.member.member_4;
let _e11476 = ((_e11461.member * _e11451) + (_e11469.member * _e11459));
let _e11477 = ((_e11461.member_1 * _e11451) + (_e11469.member_1 * _e11459));
let _e11478 = ((_e11461.member_2 * _e11451) + (_e11469.member_2 * _e11459));
let _e11481 = global_1.member.member_2.member_3;
let _e11482 = (_e11481 != 0u);
let _e11484 = global_1.member.member_5;
let _e11491 = select((_e11484.member + _e11476), _e11484.member, _e11482);
let _e11492 = select((_e11484.member_1 + _e11477), _e11484.member_1, _e11482);
let _e11493 = select((_e11484.member_2 + _e11478), _e11484.member_2, _e11482);
let _e11495 = global_1.member.member_6;
let _e11502 = select(_e11495.member, (_e11495.member + _e11476), _e11482);
let _e11503 = select(_e11495.member_1, (_e11495.member_1 + _e11477), _e11482);
let _e11504 = select(_e11495.member_2, (_e11495.member_2 + _e11478), _e11482);
let _e11509 = (((_e11491 * _e11491) + (_e11492 * _e11492)) + (_e11493 * _e11493));
let _e11512 = sqrt(select(0f, _e11509, (_e11509 > 0f)));
let _e11513 = (1f / _e11512);
let _e11514 = (_e11491 * _e11513);
let _e11515 = (_e11492 * _e11513);
let _e11516 = (_e11493 * _e11513);
let _e11517 = (_e574 - _e11502);
let _e11518 = (_e586 - _e11503);
let _e11519 = (_e599 - _e11504);
let _e11524 = (((_e11517 * _e11514) + (_e11518 * _e11515)) + (_e11519 * _e11516));
let _e11529 = (((_e11517 * _e612) + (_e11518 * _e625)) + (_e11519 * _e638));
let _e11534 = (((_e11514 * _e612) + (_e11515 * _e625)) + (_e11516 * _e638));
let _e11537 = ((_e11515 * _e638) - (_e11516 * _e625));
let _e11540 = ((_e11516 * _e612) - (_e11514 * _e638));
let _e11543 = ((_e11514 * _e625) - (_e11515 * _e612));
let _e11548 = (((_e11537 * _e11537) + (_e11540 * _e11540)) + (_e11543 * _e11543));
let _e11551 = (1f / select(1e-9f, _e11548, (_e11548 > 1e-9f)));
let _e11554 = ((_e11524 - (_e11534 * _e11529)) * _e11551);
let _e11557 = (((_e11534 * _e11524) - _e11529) * _e11551);
let _e11563 = -(_e11534);
let _e11566 = global_1.member.member_13.member_2;
let _e11567 = (_e11566 * _e11566);
let _e11571 = ((1f + _e11567) - ((2f * _e11566) * _e11563));
let _e11573 = select(1e-9f, _e11571, (_e11571 > 1e-9f));
let _e11585 = global_1.member.member_13.member_3;
let _e11593 = global_1.member.member_12.member_10;
let _e11596 = global_1.member.member_12.member_4;
let _e11599 = global_1.member.member_12.member_11;
let _e11605 = global_1.member.member.member;
let _e11607 = (_e11557 / _e690);
local_109 = bitcast<i32>((_e11593 + (_e11596 * _e11599)));
local_110 = _e280;
local_111 = bitcast<i32>(_e11605);
let _e11610 = global_1.member.member_13.member_6;
let _e11611 = f32(_e11610);
let _e11613 = select(0f, _e11607, (_e11607 > 0f));
let _e11616 = (select(1f, _e11613, (_e11613 < 1f)) * _e11611);
let _e11617 = (_e11611 - 1f);
let _e11619 = select(0f, _e11617, (_e11617 > 0f));
let _e11621 = select(0f, _e11616, (_e11616 > 0f));
let _e11623 = select(_e11619, _e11621, (_e11621 < _e11619));
let _e11630 = select(0i, select(select(i32(_e11623), i32(-2147483648), (_e11623 < -2147483600f)), 2147483647i, (_e11623 > 2147483500f)), (_e11623 == _e11623));
let _e11634 = (_e11630 - select(0i, 1i, (_e11623 < f32(_e11630))));
if (_e11634 > 0i) {
let _e11637 = local_109;
let _e11638 = local_111;
let _e11641 = local_110;
let _e11642 = ((_e11637 + ((_e11634 - 1i) * _e11638)) + _e11641);
let _e11644 = (bitcast<i32>(_e267) - 1i);
let _e11646 = select(_e11644, _e11642, (_e11642 < _e11644));
let _e11651 = global_7.member[bitcast<u32>(select(0i, _e11646, (_e11646 > 0i)))];
phi_27016_ = _e11651;
} else {
phi_27016_ = 0f;
}
let _e11653 = phi_27016_;
let _e11654 = local_109;
let _e11655 = local_111;
let _e11658 = local_110;
let _e11659 = ((_e11654 + (_e11634 * _e11655)) + _e11658);
let _e11661 = (bitcast<i32>(_e267) - 1i);
let _e11663 = select(_e11661, _e11659, (_e11659 < _e11661));
let _e11668 = global_7.member[bitcast<u32>(select(0i, _e11663, (_e11663 > 0i)))];
let _e11675 = (_e11430 - _e11419);
let _e11678 = ((_e11554 - _e11419) / select(1e-9f, _e11675, (_e11675 > 1e-9f)));
local_106 = 0i;
local_107 = _e11439;
local_108 = _e11405;
let _e11680 = select(0f, _e11678, (_e11678 > 0f));
let _e11683 = (select(1f, _e11680, (_e11680 < 1f)) * _e11611);
let _e11685 = select(0f, _e11683, (_e11683 > 0f));
let _e11687 = select(_e11619, _e11685, (_e11685 < _e11619));
let _e11694 = select(0i, select(select(i32(_e11687), i32(-2147483648), (_e11687 < -2147483600f)), 2147483647i, (_e11687 > 2147483500f)), (_e11687 == _e11687));
let _e11698 = (_e11694 - select(0i, 1i, (_e11687 < f32(_e11694))));
if (_e11698 > 0i) {
let _e11701 = local_106;
let _e11702 = local_108;
let _e11705 = local_107;
let _e11706 = ((_e11701 + ((_e11698 - 1i) * _e11702)) + _e11705);
let _e11708 = select(_e11661, _e11706, (_e11706 < _e11661));
let _e11713 = global_7.member[bitcast<u32>(select(0i, _e11708, (_e11708 > 0i)))];
phi_27143_ = _e11713;
} else {
phi_27143_ = 0f;
}
let _e11715 = phi_27143_;
let _e11716 = local_106;
let _e11717 = local_108;
let _e11720 = local_107;
let _e11721 = ((_e11716 + (_e11698 * _e11717)) + _e11720);
let _e11723 = select(_e11661, _e11721, (_e11721 < _e11661));
let _e11728 = global_7.member[bitcast<u32>(select(0i, _e11723, (_e11723 > 0i)))];
let _e11734 = ((_e11653 + ((_e11668 - _e11653) * (_e11616 - f32(_e11634)))) + (_e11715 + ((_e11728 - _e11715) * (_e11683 - f32(_e11698)))));
let _e11743 = global_1.member.member_13.member_7;
let _e11744 = bitcast<i32>(_e11743);
let _e11747 = global_1.member.member_13.member_8;
let _e11748 = bitcast<i32>(_e11747);
let _e11751 = global_1.member.member_13.member_9;
let _e11752 = bitcast<i32>(_e11751);
let _e11755 = global_1.member.member_13.member_4;
let _e11761 = global_1.member.member_13.member_5;
let _e11765 = f32(_e11744);
let _e11770 = (((((_e11502 + (_e11514 * _e11554)) - _e11755.member) / (_e11761.member - _e11755.member)) * _e11765) - 0.5f);
let _e11771 = (_e11765 - 1f);
let _e11773 = select(0f, _e11770, (_e11770 > 0f));
let _e11775 = select(_e11771, _e11773, (_e11773 < _e11771));
let _e11776 = f32(_e11748);
let _e11781 = (((((_e11503 + (_e11515 * _e11554)) - _e11755.member_1) / (_e11761.member_1 - _e11755.member_1)) * _e11776) - 0.5f);
let _e11782 = (_e11776 - 1f);
let _e11784 = select(0f, _e11781, (_e11781 > 0f));
let _e11786 = select(_e11782, _e11784, (_e11784 < _e11782));
let _e11787 = f32(_e11752);
let _e11792 = (((((_e11504 + (_e11516 * _e11554)) - _e11755.member_2) / (_e11761.member_2 - _e11755.member_2)) * _e11787) - 0.5f);
let _e11793 = (_e11787 - 1f);
let _e11795 = select(0f, _e11792, (_e11792 > 0f));
let _e11797 = select(_e11793, _e11795, (_e11795 < _e11793));
let _e11799 = select(0f, _e11775, (_e11775 > 0f));
let _e11801 = select(1e6f, _e11799, (_e11799 < 1e6f));
let _e11808 = select(0i, select(select(i32(_e11801), i32(-2147483648), (_e11801 < -2147483600f)), 2147483647i, (_e11801 > 2147483500f)), (_e11801 == _e11801));
let _e11812 = (_e11808 - select(0i, 1i, (_e11801 < f32(_e11808))));
let _e11814 = select(0f, _e11786, (_e11786 > 0f));
let _e11816 = select(1e6f, _e11814, (_e11814 < 1e6f));
let _e11823 = select(0i, select(select(i32(_e11816), i32(-2147483648), (_e11816 < -2147483600f)), 2147483647i, (_e11816 > 2147483500f)), (_e11816 == _e11816));
let _e11827 = (_e11823 - select(0i, 1i, (_e11816 < f32(_e11823))));
let _e11829 = select(0f, _e11797, (_e11797 > 0f));
let _e11831 = select(1e6f, _e11829, (_e11829 < 1e6f));
let _e11838 = select(0i, select(select(i32(_e11831), i32(-2147483648), (_e11831 < -2147483600f)), 2147483647i, (_e11831 > 2147483500f)), (_e11831 == _e11831));
let _e11842 = (_e11838 - select(0i, 1i, (_e11831 < f32(_e11838))));
let _e11846 = (_e11786 - f32(_e11827));
let _e11848 = (_e11797 - f32(_e11842));
local_104 = (_e11775 - f32(_e11812));
let _e11849 = (_e11812 + 1i);
let _e11851 = select(_e11849, 0i, (_e11849 < 0i));
if (_e11851 >= _e11744) {
phi_27291_ = (_e11744 - 1i);
} else {
phi_27291_ = _e11851;
}
let _e11855 = phi_27291_;
local_105 = (_e11855 - _e11812);
let _e11857 = (_e11827 + 1i);
let _e11859 = select(_e11857, 0i, (_e11857 < 0i));
if (_e11859 >= _e11748) {
phi_27304_ = (_e11748 - 1i);
} else {
phi_27304_ = _e11859;
}
let _e11863 = phi_27304_;
let _e11865 = ((_e11863 - _e11827) * _e11744);
let _e11866 = (_e11842 + 1i);
let _e11868 = select(_e11866, 0i, (_e11866 < 0i));
if (_e11868 >= _e11752) {
phi_27318_ = (_e11752 - 1i);
} else {
phi_27318_ = _e11868;
}
let _e11872 = phi_27318_;
let _e11878 = global_1.member.member_13.member_10;
let _e11884 = ((bitcast<i32>(_e11878) + (((_e11842 * _e11748) + _e11827) * _e11744)) + _e11812);
let _e11886 = (bitcast<i32>(_e264) - 1i);
let _e11888 = select(_e11886, _e11884, (_e11884 < _e11886));
let _e11893 = global_2.member[bitcast<u32>(select(0i, _e11888, (_e11888 > 0i)))];
let _e11894 = local_104;
let _e11897 = local_105;
let _e11898 = (_e11884 + _e11897);
let _e11900 = select(_e11886, _e11898, (_e11898 < _e11886));
let _e11905 = global_2.member[bitcast<u32>(select(0i, _e11900, (_e11900 > 0i)))];
let _e11906 = local_104;
let _e11909 = (1f - _e11846);
let _e11911 = (_e11884 + _e11865);
let _e11913 = select(_e11886, _e11911, (_e11911 < _e11886));
let _e11918 = global_2.member[bitcast<u32>(select(0i, _e11913, (_e11913 > 0i)))];
let _e11919 = local_104;
let _e11922 = local_105;
let _e11923 = (_e11911 + _e11922);
let _e11925 = select(_e11886, _e11923, (_e11923 < _e11886));
let _e11930 = global_2.member[bitcast<u32>(select(0i, _e11925, (_e11925 > 0i)))];
let _e11931 = local_104;
let _e11936 = (_e11884 + (((_e11872 - _e11842) * _e11744) * _e11748));
let _e11938 = select(_e11886, _e11936, (_e11936 < _e11886));
let _e11943 = global_2.member[bitcast<u32>(select(0i, _e11938, (_e11938 > 0i)))];
let _e11944 = local_104;
let _e11947 = local_105;
let _e11948 = (_e11936 + _e11947);
let _e11950 = select(_e11886, _e11948, (_e11948 < _e11886));
let _e11955 = global_2.member[bitcast<u32>(select(0i, _e11950, (_e11950 > 0i)))];
let _e11956 = local_104;
let _e11960 = (_e11936 + _e11865);
let _e11962 = select(_e11886, _e11960, (_e11960 < _e11886));
let _e11967 = global_2.member[bitcast<u32>(select(0i, _e11962, (_e11962 > 0i)))];
let _e11968 = local_104;
let _e11971 = local_105;
let _e11972 = (_e11960 + _e11971);
let _e11974 = select(_e11886, _e11972, (_e11972 < _e11886));
let _e11979 = global_2.member[bitcast<u32>(select(0i, _e11974, (_e11974 > 0i)))];
let _e11980 = local_104;
let _e11989 = ((_e11512 * (select(((1f - _e11567) / (_e11573 * sqrt(select(0f, _e11573, (_e11573 > 0f))))), (0.75f * (1f + (_e11563 * _e11563))), (_e11585 == 1u)) * (0.25f / 3.1415927f))) * ((((((_e11893 * (1f - _e11894)) + (_e11905 * _e11906)) * _e11909) + (((_e11918 * (1f - _e11919)) + (_e11930 * _e11931)) * _e11846)) * (1f - _e11848)) + (((((_e11943 * (1f - _e11944)) + (_e11955 * _e11956)) * _e11909) + (((_e11967 * (1f - _e11968)) + (_e11979 * _e11980)) * _e11846)) * _e11848)));
let _e11992 = global_1.member.member_13.member_1;
let _e12001 = global_1.member.member_13.member;
let _e12006 = -((_e12001.member * _e11734));
let _e12008 = select(-87f, _e12006, (_e12006 > -87f));
let _e12010 = select(88f, _e12008, (_e12008 < 88f));
let _e12012 = ((_e12010 * 1.442695f) + 0.5f);
let _e12014 = select(-127f, _e12012, (_e12012 > -127f));
let _e12016 = select(128f, _e12014, (_e12014 < 128f));
let _e12023 = select(0i, select(select(i32(_e12016), i32(-2147483648), (_e12016 < -2147483600f)), 2147483647i, (_e12016 > 2147483500f)), (_e12016 == _e12016));
let _e12027 = (_e12023 - select(0i, 1i, (_e12016 < f32(_e12023))));
let _e12028 = f32(_e12027);
let _e12032 = ((_e12010 - (_e12028 * 0.6933594f)) - (_e12028 * -2.1219444e-4f));
let _e12054 = -((_e12001.member_1 * _e11734));
let _e12056 = select(-87f, _e12054, (_e12054 > -87f));
let _e12058 = select(88f, _e12056, (_e12056 < 88f));
let _e12060 = ((_e12058 * 1.442695f) + 0.5f);
let _e12062 = select(-127f, _e12060, (_e12060 > -127f));
let _e12064 = select(128f, _e12062, (_e12062 < 128f));
let _e12071 = select(0i, select(select(i32(_e12064), i32(-2147483648), (_e12064 < -2147483600f)), 2147483647i, (_e12064 > 2147483500f)), (_e12064 == _e12064));
let _e12075 = (_e12071 - select(0i, 1i, (_e12064 < f32(_e12071))));
let _e12076 = f32(_e12075);
let _e12080 = ((_e12058 - (_e12076 * 0.6933594f)) - (_e12076 * -2.1219444e-4f));
let _e12102 = -((_e12001.member_2 * _e11734));
let _e12104 = select(-87f, _e12102, (_e12102 > -87f));
let _e12106 = select(88f, _e12104, (_e12104 < 88f));
let _e12108 = ((_e12106 * 1.442695f) + 0.5f);
let _e12110 = select(-127f, _e12108, (_e12108 > -127f));
let _e12112 = select(128f, _e12110, (_e12110 < 128f));
let _e12119 = select(0i, select(select(i32(_e12112), i32(-2147483648), (_e12112 < -2147483600f)), 2147483647i, (_e12112 > 2147483500f)), (_e12112 == _e12112));
let _e12123 = (_e12119 - select(0i, 1i, (_e12112 < f32(_e12119))));
let _e12124 = f32(_e12123);
let _e12128 = ((_e12106 - (_e12124 * 0.6933594f)) - (_e12124 * -2.1219444e-4f));
let _e12155 = select(0f, _e11554, (((_e11557 >= 0f) && (_e11557 < _e690)) && (_e11554 > 0f)));
if _e452 {
phi_27777_ = type_23(_e7049, _e7048);
} else {
phi_27777_ = type_23(_e7048, _e7049);
}
let _e12159 = phi_27777_;
let _e12164 = f32((1i << bitcast<u32>(_e7037)));
let _e12165 = (1f / _e12164);
let _e12167 = ((_e11256 * _e12165) - 0.5f);
let _e12169 = ((_e11350 * _e12165) - 0.5f);
let _e12171 = select(-1f, _e12167, (_e12167 > -1f));
let _e12173 = select(1e6f, _e12171, (_e12171 < 1e6f));
let _e12180 = select(0i, select(select(i32(_e12173), i32(-2147483648), (_e12173 < -2147483600f)), 2147483647i, (_e12173 > 2147483500f)), (_e12173 == _e12173));
let _e12184 = (_e12180 - select(0i, 1i, (_e12173 < f32(_e12180))));
let _e12186 = select(-1f, _e12169, (_e12169 > -1f));
let _e12188 = select(1e6f, _e12186, (_e12186 < 1e6f));
let _e12195 = select(0i, select(select(i32(_e12188), i32(-2147483648), (_e12188 < -2147483600f)), 2147483647i, (_e12188 > 2147483500f)), (_e12188 == _e12188));
let _e12199 = (_e12195 - select(0i, 1i, (_e12188 < f32(_e12195))));
let _e12201 = (_e12167 - f32(_e12184));
let _e12203 = (_e12169 - f32(_e12199));
let _e12204 = (1f - _e12201);
let _e12205 = (1f - _e12203);
let _e12208 = select(_e12184, 0i, (_e12184 < 0i));
let _e12209 = (_e12208 >= _e12159.member);
if _e12209 {
phi_27855_ = (_e12159.member - 1i);
} else {
phi_27855_ = _e12208;
}
let _e12212 = phi_27855_;
let _e12214 = select(_e12199, 0i, (_e12199 < 0i));
let _e12215 = (_e12214 >= _e12159.member_1);
if _e12215 {
phi_27866_ = (_e12159.member_1 - 1i);
} else {
phi_27866_ = _e12214;
}
let _e12218 = phi_27866_;
let _e12222 = (((f32(_e12212) + 0.5f) * _e12164) - 0.5f);
let _e12226 = (((f32(_e12218) + 0.5f) * _e12164) - 0.5f);
if _e452 {
phi_27894_ = type_23(_e12218, _e12212);
} else {
phi_27894_ = type_23(_e12212, _e12218);
}
let _e12232 = phi_27894_;
let _e12238 = bitcast<i32>(((_e930 + 1u) >> bitcast<u32>(1u)));
let _e12241 = global_1.member.member_18.member_6;
let _e12244 = global_1.member.member_18.member_7;
let _e12247 = global_1.member.member_18.member_8;
if _e985 {
phi_27945_ = 0u;
} else {
if (_e765 == 1u) {
phi_27944_ = 0u;
} else {
if (_e765 == 2u) {
phi_27943_ = _e12241;
} else {
phi_27943_ = select(_e12247, _e12244, (_e765 == 3u));
}
let _e12253 = phi_27943_;
phi_27944_ = _e12253;
}
let _e12255 = phi_27944_;
phi_27945_ = _e12255;
}
let _e12257 = phi_27945_;
local_102 = (((bitcast<i32>(_e12257) + _e12232.member_1) * _e12238) + _e12232.member);
let _e12262 = local_102;
let _e12264 = (bitcast<i32>(_e261) - 1i);
let _e12266 = select(_e12264, _e12262, (_e12262 < _e12264));
let _e12271 = global_6.member[bitcast<u32>(select(0i, _e12266, (_e12266 > 0i)))];
let _e12276 = (((((select(_e12222, _e12226, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e12281 = ((1f - (((select(_e12226, _e12222, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e12288 = ((_e11461.member * _e12276) + (_e11469.member * _e12281));
let _e12289 = ((_e11461.member_1 * _e12276) + (_e11469.member_1 * _e12281));
let _e12290 = ((_e11461.member_2 * _e12276) + (_e11469.member_2 * _e12281));
let _e12294 = select((_e11484.member + _e12288), _e11484.member, _e11482);
let _e12295 = select((_e11484.member_1 + _e12289), _e11484.member_1, _e11482);
let _e12296 = select((_e11484.member_2 + _e12290), _e11484.member_2, _e11482);
let _e12307 = (((_e12294 * _e12294) + (_e12295 * _e12295)) + (_e12296 * _e12296));
let _e12311 = (1f / sqrt(select(0f, _e12307, (_e12307 > 0f))));
let _e12312 = (_e12294 * _e12311);
let _e12313 = (_e12295 * _e12311);
let _e12314 = (_e12296 * _e12311);
let _e12315 = (_e574 - select(_e11495.member, (_e11495.member + _e12288), _e11482));
let _e12316 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e12289), _e11482));
let _e12317 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e12290), _e11482));
let _e12322 = (((_e12315 * _e12312) + (_e12316 * _e12313)) + (_e12317 * _e12314));
let _e12327 = (((_e12315 * _e612) + (_e12316 * _e625)) + (_e12317 * _e638));
let _e12332 = (((_e12312 * _e612) + (_e12313 * _e625)) + (_e12314 * _e638));
let _e12335 = ((_e12313 * _e638) - (_e12314 * _e625));
let _e12338 = ((_e12314 * _e612) - (_e12312 * _e638));
let _e12341 = ((_e12312 * _e625) - (_e12313 * _e612));
let _e12346 = (((_e12335 * _e12335) + (_e12338 * _e12338)) + (_e12341 * _e12341));
let _e12349 = (1f / select(1e-9f, _e12346, (_e12346 > 1e-9f)));
let _e12352 = ((_e12322 - (_e12332 * _e12327)) * _e12349);
let _e12355 = (((_e12332 * _e12322) - _e12327) * _e12349);
let _e12361 = select(0f, _e12352, (((_e12355 >= 0f) && (_e12355 < _e690)) && (_e12352 > 0f)));
let _e12363 = (_e12212 << bitcast<u32>(_e7037));
let _e12375 = (_e12184 + 1i);
let _e12378 = select(_e12375, 0i, (_e12375 < 0i));
let _e12379 = (_e12378 >= _e12159.member);
if _e12379 {
phi_28492_ = (_e12159.member - 1i);
} else {
phi_28492_ = _e12378;
}
let _e12382 = phi_28492_;
if _e12215 {
phi_28503_ = (_e12159.member_1 - 1i);
} else {
phi_28503_ = _e12214;
}
let _e12385 = phi_28503_;
let _e12389 = (((f32(_e12382) + 0.5f) * _e12164) - 0.5f);
let _e12393 = (((f32(_e12385) + 0.5f) * _e12164) - 0.5f);
if _e452 {
phi_28531_ = type_23(_e12385, _e12382);
} else {
phi_28531_ = type_23(_e12382, _e12385);
}
let _e12399 = phi_28531_;
if _e985 {
phi_28582_ = 0u;
} else {
if (_e765 == 1u) {
phi_28581_ = 0u;
} else {
if (_e765 == 2u) {
phi_28580_ = _e12241;
} else {
phi_28580_ = select(_e12247, _e12244, (_e765 == 3u));
}
let _e12407 = phi_28580_;
phi_28581_ = _e12407;
}
let _e12409 = phi_28581_;
phi_28582_ = _e12409;
}
let _e12411 = phi_28582_;
local_100 = (((bitcast<i32>(_e12411) + _e12399.member_1) * _e12238) + _e12399.member);
let _e12416 = local_100;
let _e12418 = select(_e12264, _e12416, (_e12416 < _e12264));
let _e12423 = global_6.member[bitcast<u32>(select(0i, _e12418, (_e12418 > 0i)))];
let _e12428 = (((((select(_e12389, _e12393, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e12433 = ((1f - (((select(_e12393, _e12389, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e12440 = ((_e11461.member * _e12428) + (_e11469.member * _e12433));
let _e12441 = ((_e11461.member_1 * _e12428) + (_e11469.member_1 * _e12433));
let _e12442 = ((_e11461.member_2 * _e12428) + (_e11469.member_2 * _e12433));
let _e12446 = select((_e11484.member + _e12440), _e11484.member, _e11482);
let _e12447 = select((_e11484.member_1 + _e12441), _e11484.member_1, _e11482);
let _e12448 = select((_e11484.member_2 + _e12442), _e11484.member_2, _e11482);
let _e12459 = (((_e12446 * _e12446) + (_e12447 * _e12447)) + (_e12448 * _e12448));
let _e12463 = (1f / sqrt(select(0f, _e12459, (_e12459 > 0f))));
let _e12464 = (_e12446 * _e12463);
let _e12465 = (_e12447 * _e12463);
let _e12466 = (_e12448 * _e12463);
let _e12467 = (_e574 - select(_e11495.member, (_e11495.member + _e12440), _e11482));
let _e12468 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e12441), _e11482));
let _e12469 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e12442), _e11482));
let _e12474 = (((_e12467 * _e12464) + (_e12468 * _e12465)) + (_e12469 * _e12466));
let _e12479 = (((_e12467 * _e612) + (_e12468 * _e625)) + (_e12469 * _e638));
let _e12484 = (((_e12464 * _e612) + (_e12465 * _e625)) + (_e12466 * _e638));
let _e12487 = ((_e12465 * _e638) - (_e12466 * _e625));
let _e12490 = ((_e12466 * _e612) - (_e12464 * _e638));
let _e12493 = ((_e12464 * _e625) - (_e12465 * _e612));
let _e12498 = (((_e12487 * _e12487) + (_e12490 * _e12490)) + (_e12493 * _e12493));
let _e12501 = (1f / select(1e-9f, _e12498, (_e12498 > 1e-9f)));
let _e12504 = ((_e12474 - (_e12484 * _e12479)) * _e12501);
let _e12507 = (((_e12484 * _e12474) - _e12479) * _e12501);
let _e12513 = select(0f, _e12504, (((_e12507 >= 0f) && (_e12507 < _e690)) && (_e12504 > 0f)));
let _e12515 = (_e12382 << bitcast<u32>(_e7037));
let _e12527 = (_e12199 + 1i);
if _e12209 {
phi_29129_ = (_e12159.member - 1i);
} else {
phi_29129_ = _e12208;
}
let _e12531 = phi_29129_;
let _e12533 = select(_e12527, 0i, (_e12527 < 0i));
let _e12534 = (_e12533 >= _e12159.member_1);
if _e12534 {
phi_29140_ = (_e12159.member_1 - 1i);
} else {
phi_29140_ = _e12533;
}
let _e12537 = phi_29140_;
let _e12541 = (((f32(_e12531) + 0.5f) * _e12164) - 0.5f);
let _e12545 = (((f32(_e12537) + 0.5f) * _e12164) - 0.5f);
if _e452 {
phi_29168_ = type_23(_e12537, _e12531);
} else {
phi_29168_ = type_23(_e12531, _e12537);
}
let _e12551 = phi_29168_;
if _e985 {
phi_29219_ = 0u;
} else {
if (_e765 == 1u) {
phi_29218_ = 0u;
} else {
if (_e765 == 2u) {
phi_29217_ = _e12241;
} else {
phi_29217_ = select(_e12247, _e12244, (_e765 == 3u));
}
let _e12559 = phi_29217_;
phi_29218_ = _e12559;
}
let _e12561 = phi_29218_;
phi_29219_ = _e12561;
}
let _e12563 = phi_29219_;
local_98 = (((bitcast<i32>(_e12563) + _e12551.member_1) * _e12238) + _e12551.member);
let _e12568 = local_98;
let _e12570 = select(_e12264, _e12568, (_e12568 < _e12264));
let _e12575 = global_6.member[bitcast<u32>(select(0i, _e12570, (_e12570 > 0i)))];
let _e12580 = (((((select(_e12541, _e12545, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e12585 = ((1f - (((select(_e12545, _e12541, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e12592 = ((_e11461.member * _e12580) + (_e11469.member * _e12585));
let _e12593 = ((_e11461.member_1 * _e12580) + (_e11469.member_1 * _e12585));
let _e12594 = ((_e11461.member_2 * _e12580) + (_e11469.member_2 * _e12585));
let _e12598 = select((_e11484.member + _e12592), _e11484.member, _e11482);
let _e12599 = select((_e11484.member_1 + _e12593), _e11484.member_1, _e11482);
let _e12600 = select((_e11484.member_2 + _e12594), _e11484.member_2, _e11482);
let _e12611 = (((_e12598 * _e12598) + (_e12599 * _e12599)) + (_e12600 * _e12600));
let _e12615 = (1f / sqrt(select(0f, _e12611, (_e12611 > 0f))));
let _e12616 = (_e12598 * _e12615);
let _e12617 = (_e12599 * _e12615);
let _e12618 = (_e12600 * _e12615);
let _e12619 = (_e574 - select(_e11495.member, (_e11495.member + _e12592), _e11482));
let _e12620 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e12593), _e11482));
let _e12621 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e12594), _e11482));
let _e12626 = (((_e12619 * _e12616) + (_e12620 * _e12617)) + (_e12621 * _e12618));
let _e12631 = (((_e12619 * _e612) + (_e12620 * _e625)) + (_e12621 * _e638));
let _e12636 = (((_e12616 * _e612) + (_e12617 * _e625)) + (_e12618 * _e638));
let _e12639 = ((_e12617 * _e638) - (_e12618 * _e625));
let _e12642 = ((_e12618 * _e612) - (_e12616 * _e638));
let _e12645 = ((_e12616 * _e625) - (_e12617 * _e612));
let _e12650 = (((_e12639 * _e12639) + (_e12642 * _e12642)) + (_e12645 * _e12645));
let _e12653 = (1f / select(1e-9f, _e12650, (_e12650 > 1e-9f)));
let _e12656 = ((_e12626 - (_e12636 * _e12631)) * _e12653);
let _e12659 = (((_e12636 * _e12626) - _e12631) * _e12653);
let _e12665 = select(0f, _e12656, (((_e12659 >= 0f) && (_e12659 < _e690)) && (_e12656 > 0f)));
let _e12667 = (_e12531 << bitcast<u32>(_e7037));
if _e12379 {
phi_29766_ = (_e12159.member - 1i);
} else {
phi_29766_ = _e12378;
}
let _e12682 = phi_29766_;
if _e12534 {
phi_29777_ = (_e12159.member_1 - 1i);
} else {
phi_29777_ = _e12533;
}
let _e12685 = phi_29777_;
let _e12689 = (((f32(_e12682) + 0.5f) * _e12164) - 0.5f);
let _e12693 = (((f32(_e12685) + 0.5f) * _e12164) - 0.5f);
if _e452 {
phi_29805_ = type_23(_e12685, _e12682);
} else {
phi_29805_ = type_23(_e12682, _e12685);
}
let _e12699 = phi_29805_;
if _e985 {
phi_29856_ = 0u;
} else {
if (_e765 == 1u) {
phi_29855_ = 0u;
} else {
if (_e765 == 2u) {
phi_29854_ = _e12241;
} else {
phi_29854_ = select(_e12247, _e12244, (_e765 == 3u));
}
let _e12707 = phi_29854_;
phi_29855_ = _e12707;
}
let _e12709 = phi_29855_;
phi_29856_ = _e12709;
}
let _e12711 = phi_29856_;
local_96 = (((bitcast<i32>(_e12711) + _e12699.member_1) * _e12238) + _e12699.member);
let _e12716 = local_96;
let _e12718 = select(_e12264, _e12716, (_e12716 < _e12264));
let _e12723 = global_6.member[bitcast<u32>(select(0i, _e12718, (_e12718 > 0i)))];
let _e12728 = (((((select(_e12689, _e12693, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e12733 = ((1f - (((select(_e12693, _e12689, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e12740 = ((_e11461.member * _e12728) + (_e11469.member * _e12733));
let _e12741 = ((_e11461.member_1 * _e12728) + (_e11469.member_1 * _e12733));
let _e12742 = ((_e11461.member_2 * _e12728) + (_e11469.member_2 * _e12733));
let _e12746 = select((_e11484.member + _e12740), _e11484.member, _e11482);
let _e12747 = select((_e11484.member_1 + _e12741), _e11484.member_1, _e11482);
let _e12748 = select((_e11484.member_2 + _e12742), _e11484.member_2, _e11482);
let _e12759 = (((_e12746 * _e12746) + (_e12747 * _e12747)) + (_e12748 * _e12748));
let _e12763 = (1f / sqrt(select(0f, _e12759, (_e12759 > 0f))));
let _e12764 = (_e12746 * _e12763);
let _e12765 = (_e12747 * _e12763);
let _e12766 = (_e12748 * _e12763);
let _e12767 = (_e574 - select(_e11495.member, (_e11495.member + _e12740), _e11482));
let _e12768 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e12741), _e11482));
let _e12769 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e12742), _e11482));
let _e12774 = (((_e12767 * _e12764) + (_e12768 * _e12765)) + (_e12769 * _e12766));
let _e12779 = (((_e12767 * _e612) + (_e12768 * _e625)) + (_e12769 * _e638));
let _e12784 = (((_e12764 * _e612) + (_e12765 * _e625)) + (_e12766 * _e638));
let _e12787 = ((_e12765 * _e638) - (_e12766 * _e625));
let _e12790 = ((_e12766 * _e612) - (_e12764 * _e638));
let _e12793 = ((_e12764 * _e625) - (_e12765 * _e612));
let _e12798 = (((_e12787 * _e12787) + (_e12790 * _e12790)) + (_e12793 * _e12793));
let _e12801 = (1f / select(1e-9f, _e12798, (_e12798 > 1e-9f)));
let _e12804 = ((_e12774 - (_e12784 * _e12779)) * _e12801);
let _e12807 = (((_e12784 * _e12774) - _e12779) * _e12801);
let _e12813 = select(0f, _e12804, (((_e12807 >= 0f) && (_e12807 < _e690)) && (_e12804 > 0f)));
let _e12815 = (_e12682 << bitcast<u32>(_e7037));
let _e12827 = select(((((1f - select(0f, (_e12204 * _e12205), (((select(select(_e765, _e926, (_e12363 >= _e691)), _e846, (_e12363 < _e297)) == _e765) && (_e12361 > 0f)) && (_e12361 < _e12271)))) - select(0f, (_e12201 * _e12205), (((select(select(_e765, _e926, (_e12515 >= _e691)), _e846, (_e12515 < _e297)) == _e765) && (_e12513 > 0f)) && (_e12513 < _e12423)))) - select(0f, (_e12204 * _e12203), (((select(select(_e765, _e926, (_e12667 >= _e691)), _e846, (_e12667 < _e297)) == _e765) && (_e12665 > 0f)) && (_e12665 < _e12575)))) - select(0f, (_e12201 * _e12203), (((select(select(_e765, _e926, (_e12815 >= _e691)), _e846, (_e12815 < _e297)) == _e765) && (_e12813 > 0f)) && (_e12813 < _e12723)))), 1f, _e985);
let _e12828 = (_e8333 & 31u);
let _e12830 = (1u << bitcast<u32>(_e12828));
let _e12839 = bitcast<i32>((((_e930 + _e12830) - 1u) >> bitcast<u32>(_e12828)));
let _e12840 = bitcast<i32>((((_e933 + _e12830) - 1u) >> bitcast<u32>(_e12828)));
if _e452 {
phi_30421_ = type_23(_e12840, _e12839);
} else {
phi_30421_ = type_23(_e12839, _e12840);
}
let _e12844 = phi_30421_;
let _e12849 = f32((1i << bitcast<u32>(_e12828)));
let _e12850 = (1f / _e12849);
let _e12852 = ((_e11256 * _e12850) - 0.5f);
let _e12854 = ((_e11350 * _e12850) - 0.5f);
let _e12856 = select(-1f, _e12852, (_e12852 > -1f));
let _e12858 = select(1e6f, _e12856, (_e12856 < 1e6f));
let _e12865 = select(0i, select(select(i32(_e12858), i32(-2147483648), (_e12858 < -2147483600f)), 2147483647i, (_e12858 > 2147483500f)), (_e12858 == _e12858));
let _e12869 = (_e12865 - select(0i, 1i, (_e12858 < f32(_e12865))));
let _e12871 = select(-1f, _e12854, (_e12854 > -1f));
let _e12873 = select(1e6f, _e12871, (_e12871 < 1e6f));
let _e12880 = select(0i, select(select(i32(_e12873), i32(-2147483648), (_e12873 < -2147483600f)), 2147483647i, (_e12873 > 2147483500f)), (_e12873 == _e12873));
let _e12884 = (_e12880 - select(0i, 1i, (_e12873 < f32(_e12880))));
let _e12886 = (_e12852 - f32(_e12869));
let _e12888 = (_e12854 - f32(_e12884));
let _e12889 = (1f - _e12886);
let _e12890 = (1f - _e12888);
let _e12893 = select(_e12869, 0i, (_e12869 < 0i));
let _e12894 = (_e12893 >= _e12844.member);
if _e12894 {
phi_30499_ = (_e12844.member - 1i);
} else {
phi_30499_ = _e12893;
}
let _e12897 = phi_30499_;
let _e12899 = select(_e12884, 0i, (_e12884 < 0i));
let _e12900 = (_e12899 >= _e12844.member_1);
if _e12900 {
phi_30510_ = (_e12844.member_1 - 1i);
} else {
phi_30510_ = _e12899;
}
let _e12903 = phi_30510_;
let _e12907 = (((f32(_e12897) + 0.5f) * _e12849) - 0.5f);
let _e12911 = (((f32(_e12903) + 0.5f) * _e12849) - 0.5f);
if _e452 {
phi_30538_ = type_23(_e12903, _e12897);
} else {
phi_30538_ = type_23(_e12897, _e12903);
}
let _e12917 = phi_30538_;
let _e12920 = (_e8333 == 0u);
if _e12920 {
phi_30589_ = 0u;
} else {
if (_e8333 == 1u) {
phi_30588_ = 0u;
} else {
if (_e8333 == 2u) {
phi_30587_ = _e12241;
} else {
phi_30587_ = select(_e12247, _e12244, (_e8333 == 3u));
}
let _e12926 = phi_30587_;
phi_30588_ = _e12926;
}
let _e12928 = phi_30588_;
phi_30589_ = _e12928;
}
let _e12930 = phi_30589_;
local_94 = (((bitcast<i32>(_e12930) + _e12917.member_1) * _e12238) + _e12917.member);
let _e12935 = local_94;
let _e12937 = select(_e12264, _e12935, (_e12935 < _e12264));
let _e12942 = global_6.member[bitcast<u32>(select(0i, _e12937, (_e12937 > 0i)))];
let _e12947 = (((((select(_e12907, _e12911, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e12952 = ((1f - (((select(_e12911, _e12907, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e12959 = ((_e11461.member * _e12947) + (_e11469.member * _e12952));
let _e12960 = ((_e11461.member_1 * _e12947) + (_e11469.member_1 * _e12952));
let _e12961 = ((_e11461.member_2 * _e12947) + (_e11469.member_2 * _e12952));
let _e12965 = select((_e11484.member + _e12959), _e11484.member, _e11482);
let _e12966 = select((_e11484.member_1 + _e12960), _e11484.member_1, _e11482);
let _e12967 = select((_e11484.member_2 + _e12961), _e11484.member_2, _e11482);
let _e12978 = (((_e12965 * _e12965) + (_e12966 * _e12966)) + (_e12967 * _e12967));
let _e12982 = (1f / sqrt(select(0f, _e12978, (_e12978 > 0f))));
let _e12983 = (_e12965 * _e12982);
let _e12984 = (_e12966 * _e12982);
let _e12985 = (_e12967 * _e12982);
let _e12986 = (_e574 - select(_e11495.member, (_e11495.member + _e12959), _e11482));
let _e12987 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e12960), _e11482));
let _e12988 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e12961), _e11482));
let _e12993 = (((_e12986 * _e12983) + (_e12987 * _e12984)) + (_e12988 * _e12985));
let _e12998 = (((_e12986 * _e612) + (_e12987 * _e625)) + (_e12988 * _e638));
let _e13003 = (((_e12983 * _e612) + (_e12984 * _e625)) + (_e12985 * _e638));
let _e13006 = ((_e12984 * _e638) - (_e12985 * _e625));
let _e13009 = ((_e12985 * _e612) - (_e12983 * _e638));
let _e13012 = ((_e12983 * _e625) - (_e12984 * _e612));
let _e13017 = (((_e13006 * _e13006) + (_e13009 * _e13009)) + (_e13012 * _e13012));
let _e13020 = (1f / select(1e-9f, _e13017, (_e13017 > 1e-9f)));
let _e13023 = ((_e12993 - (_e13003 * _e12998)) * _e13020);
let _e13026 = (((_e13003 * _e12993) - _e12998) * _e13020);
let _e13032 = select(0f, _e13023, (((_e13026 >= 0f) && (_e13026 < _e690)) && (_e13023 > 0f)));
let _e13034 = (_e12897 << bitcast<u32>(_e12828));
let _e13046 = (_e12869 + 1i);
let _e13049 = select(_e13046, 0i, (_e13046 < 0i));
let _e13050 = (_e13049 >= _e12844.member);
if _e13050 {
phi_31136_ = (_e12844.member - 1i);
} else {
phi_31136_ = _e13049;
}
let _e13053 = phi_31136_;
if _e12900 {
phi_31147_ = (_e12844.member_1 - 1i);
} else {
phi_31147_ = _e12899;
}
let _e13056 = phi_31147_;
let _e13060 = (((f32(_e13053) + 0.5f) * _e12849) - 0.5f);
let _e13064 = (((f32(_e13056) + 0.5f) * _e12849) - 0.5f);
if _e452 {
phi_31175_ = type_23(_e13056, _e13053);
} else {
phi_31175_ = type_23(_e13053, _e13056);
}
let _e13070 = phi_31175_;
if _e12920 {
phi_31226_ = 0u;
} else {
if (_e8333 == 1u) {
phi_31225_ = 0u;
} else {
if (_e8333 == 2u) {
phi_31224_ = _e12241;
} else {
phi_31224_ = select(_e12247, _e12244, (_e8333 == 3u));
}
let _e13078 = phi_31224_;
phi_31225_ = _e13078;
}
let _e13080 = phi_31225_;
phi_31226_ = _e13080;
}
let _e13082 = phi_31226_;
local_92 = (((bitcast<i32>(_e13082) + _e13070.member_1) * _e12238) + _e13070.member);
let _e13087 = local_92;
let _e13089 = select(_e12264, _e13087, (_e13087 < _e12264));
let _e13094 = global_6.member[bitcast<u32>(select(0i, _e13089, (_e13089 > 0i)))];
let _e13099 = (((((select(_e13060, _e13064, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13104 = ((1f - (((select(_e13064, _e13060, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13111 = ((_e11461.member * _e13099) + (_e11469.member * _e13104));
let _e13112 = ((_e11461.member_1 * _e13099) + (_e11469.member_1 * _e13104));
let _e13113 = ((_e11461.member_2 * _e13099) + (_e11469.member_2 * _e13104));
let _e13117 = select((_e11484.member + _e13111), _e11484.member, _e11482);
let _e13118 = select((_e11484.member_1 + _e13112), _e11484.member_1, _e11482);
let _e13119 = select((_e11484.member_2 + _e13113), _e11484.member_2, _e11482);
let _e13130 = (((_e13117 * _e13117) + (_e13118 * _e13118)) + (_e13119 * _e13119));
let _e13134 = (1f / sqrt(select(0f, _e13130, (_e13130 > 0f))));
let _e13135 = (_e13117 * _e13134);
let _e13136 = (_e13118 * _e13134);
let _e13137 = (_e13119 * _e13134);
let _e13138 = (_e574 - select(_e11495.member, (_e11495.member + _e13111), _e11482));
let _e13139 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13112), _e11482));
let _e13140 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13113), _e11482));
let _e13145 = (((_e13138 * _e13135) + (_e13139 * _e13136)) + (_e13140 * _e13137));
let _e13150 = (((_e13138 * _e612) + (_e13139 * _e625)) + (_e13140 * _e638));
let _e13155 = (((_e13135 * _e612) + (_e13136 * _e625)) + (_e13137 * _e638));
let _e13158 = ((_e13136 * _e638) - (_e13137 * _e625));
let _e13161 = ((_e13137 * _e612) - (_e13135 * _e638));
let _e13164 = ((_e13135 * _e625) - (_e13136 * _e612));
let _e13169 = (((_e13158 * _e13158) + (_e13161 * _e13161)) + (_e13164 * _e13164));
let _e13172 = (1f / select(1e-9f, _e13169, (_e13169 > 1e-9f)));
let _e13175 = ((_e13145 - (_e13155 * _e13150)) * _e13172);
let _e13178 = (((_e13155 * _e13145) - _e13150) * _e13172);
let _e13184 = select(0f, _e13175, (((_e13178 >= 0f) && (_e13178 < _e690)) && (_e13175 > 0f)));
let _e13186 = (_e13053 << bitcast<u32>(_e12828));
let _e13198 = (_e12884 + 1i);
if _e12894 {
phi_31773_ = (_e12844.member - 1i);
} else {
phi_31773_ = _e12893;
}
let _e13202 = phi_31773_;
let _e13204 = select(_e13198, 0i, (_e13198 < 0i));
let _e13205 = (_e13204 >= _e12844.member_1);
if _e13205 {
phi_31784_ = (_e12844.member_1 - 1i);
} else {
phi_31784_ = _e13204;
}
let _e13208 = phi_31784_;
let _e13212 = (((f32(_e13202) + 0.5f) * _e12849) - 0.5f);
let _e13216 = (((f32(_e13208) + 0.5f) * _e12849) - 0.5f);
if _e452 {
phi_31812_ = type_23(_e13208, _e13202);
} else {
phi_31812_ = type_23(_e13202, _e13208);
}
let _e13222 = phi_31812_;
if _e12920 {
phi_31863_ = 0u;
} else {
if (_e8333 == 1u) {
phi_31862_ = 0u;
} else {
if (_e8333 == 2u) {
phi_31861_ = _e12241;
} else {
phi_31861_ = select(_e12247, _e12244, (_e8333 == 3u));
}
let _e13230 = phi_31861_;
phi_31862_ = _e13230;
}
let _e13232 = phi_31862_;
phi_31863_ = _e13232;
}
let _e13234 = phi_31863_;
local_90 = (((bitcast<i32>(_e13234) + _e13222.member_1) * _e12238) + _e13222.member);
let _e13239 = local_90;
let _e13241 = select(_e12264, _e13239, (_e13239 < _e12264));
let _e13246 = global_6.member[bitcast<u32>(select(0i, _e13241, (_e13241 > 0i)))];
let _e13251 = (((((select(_e13212, _e13216, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13256 = ((1f - (((select(_e13216, _e13212, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13263 = ((_e11461.member * _e13251) + (_e11469.member * _e13256));
let _e13264 = ((_e11461.member_1 * _e13251) + (_e11469.member_1 * _e13256));
let _e13265 = ((_e11461.member_2 * _e13251) + (_e11469.member_2 * _e13256));
let _e13269 = select((_e11484.member + _e13263), _e11484.member, _e11482);
let _e13270 = select((_e11484.member_1 + _e13264), _e11484.member_1, _e11482);
let _e13271 = select((_e11484.member_2 + _e13265), _e11484.member_2, _e11482);
let _e13282 = (((_e13269 * _e13269) + (_e13270 * _e13270)) + (_e13271 * _e13271));
let _e13286 = (1f / sqrt(select(0f, _e13282, (_e13282 > 0f))));
let _e13287 = (_e13269 * _e13286);
let _e13288 = (_e13270 * _e13286);
let _e13289 = (_e13271 * _e13286);
let _e13290 = (_e574 - select(_e11495.member, (_e11495.member + _e13263), _e11482));
let _e13291 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13264), _e11482));
let _e13292 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13265), _e11482));
let _e13297 = (((_e13290 * _e13287) + (_e13291 * _e13288)) + (_e13292 * _e13289));
let _e13302 = (((_e13290 * _e612) + (_e13291 * _e625)) + (_e13292 * _e638));
let _e13307 = (((_e13287 * _e612) + (_e13288 * _e625)) + (_e13289 * _e638));
let _e13310 = ((_e13288 * _e638) - (_e13289 * _e625));
let _e13313 = ((_e13289 * _e612) - (_e13287 * _e638));
let _e13316 = ((_e13287 * _e625) - (_e13288 * _e612));
let _e13321 = (((_e13310 * _e13310) + (_e13313 * _e13313)) + (_e13316 * _e13316));
let _e13324 = (1f / select(1e-9f, _e13321, (_e13321 > 1e-9f)));
let _e13327 = ((_e13297 - (_e13307 * _e13302)) * _e13324);
let _e13330 = (((_e13307 * _e13297) - _e13302) * _e13324);
let _e13336 = select(0f, _e13327, (((_e13330 >= 0f) && (_e13330 < _e690)) && (_e13327 > 0f)));
let _e13338 = (_e13202 << bitcast<u32>(_e12828));
if _e13050 {
phi_32410_ = (_e12844.member - 1i);
} else {
phi_32410_ = _e13049;
}
let _e13353 = phi_32410_;
if _e13205 {
phi_32421_ = (_e12844.member_1 - 1i);
} else {
phi_32421_ = _e13204;
}
let _e13356 = phi_32421_;
let _e13360 = (((f32(_e13353) + 0.5f) * _e12849) - 0.5f);
let _e13364 = (((f32(_e13356) + 0.5f) * _e12849) - 0.5f);
if _e452 {
phi_32449_ = type_23(_e13356, _e13353);
} else {
phi_32449_ = type_23(_e13353, _e13356);
}
let _e13370 = phi_32449_;
if _e12920 {
phi_32500_ = 0u;
} else {
if (_e8333 == 1u) {
phi_32499_ = 0u;
} else {
if (_e8333 == 2u) {
phi_32498_ = _e12241;
} else {
phi_32498_ = select(_e12247, _e12244, (_e8333 == 3u));
}
let _e13378 = phi_32498_;
phi_32499_ = _e13378;
}
let _e13380 = phi_32499_;
phi_32500_ = _e13380;
}
let _e13382 = phi_32500_;
local_88 = (((bitcast<i32>(_e13382) + _e13370.member_1) * _e12238) + _e13370.member);
let _e13387 = local_88;
let _e13389 = select(_e12264, _e13387, (_e13387 < _e12264));
let _e13394 = global_6.member[bitcast<u32>(select(0i, _e13389, (_e13389 > 0i)))];
let _e13399 = (((((select(_e13360, _e13364, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13404 = ((1f - (((select(_e13364, _e13360, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13411 = ((_e11461.member * _e13399) + (_e11469.member * _e13404));
let _e13412 = ((_e11461.member_1 * _e13399) + (_e11469.member_1 * _e13404));
let _e13413 = ((_e11461.member_2 * _e13399) + (_e11469.member_2 * _e13404));
let _e13417 = select((_e11484.member + _e13411), _e11484.member, _e11482);
let _e13418 = select((_e11484.member_1 + _e13412), _e11484.member_1, _e11482);
let _e13419 = select((_e11484.member_2 + _e13413), _e11484.member_2, _e11482);
let _e13430 = (((_e13417 * _e13417) + (_e13418 * _e13418)) + (_e13419 * _e13419));
let _e13434 = (1f / sqrt(select(0f, _e13430, (_e13430 > 0f))));
let _e13435 = (_e13417 * _e13434);
let _e13436 = (_e13418 * _e13434);
let _e13437 = (_e13419 * _e13434);
let _e13438 = (_e574 - select(_e11495.member, (_e11495.member + _e13411), _e11482));
let _e13439 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13412), _e11482));
let _e13440 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13413), _e11482));
let _e13445 = (((_e13438 * _e13435) + (_e13439 * _e13436)) + (_e13440 * _e13437));
let _e13450 = (((_e13438 * _e612) + (_e13439 * _e625)) + (_e13440 * _e638));
let _e13455 = (((_e13435 * _e612) + (_e13436 * _e625)) + (_e13437 * _e638));
let _e13458 = ((_e13436 * _e638) - (_e13437 * _e625));
let _e13461 = ((_e13437 * _e612) - (_e13435 * _e638));
let _e13464 = ((_e13435 * _e625) - (_e13436 * _e612));
let _e13469 = (((_e13458 * _e13458) + (_e13461 * _e13461)) + (_e13464 * _e13464));
let _e13472 = (1f / select(1e-9f, _e13469, (_e13469 > 1e-9f)));
let _e13475 = ((_e13445 - (_e13455 * _e13450)) * _e13472);
let _e13478 = (((_e13455 * _e13445) - _e13450) * _e13472);
let _e13484 = select(0f, _e13475, (((_e13478 >= 0f) && (_e13478 < _e690)) && (_e13475 > 0f)));
let _e13486 = (_e13353 << bitcast<u32>(_e12828));
let _e13498 = select(((((_e12827 - select(0f, (_e12889 * _e12890), (((select(select(_e765, _e926, (_e13034 >= _e691)), _e846, (_e13034 < _e297)) == _e8333) && (_e13032 > 0f)) && (_e13032 < _e12942)))) - select(0f, (_e12886 * _e12890), (((select(select(_e765, _e926, (_e13186 >= _e691)), _e846, (_e13186 < _e297)) == _e8333) && (_e13184 > 0f)) && (_e13184 < _e13094)))) - select(0f, (_e12889 * _e12888), (((select(select(_e765, _e926, (_e13338 >= _e691)), _e846, (_e13338 < _e297)) == _e8333) && (_e13336 > 0f)) && (_e13336 < _e13246)))) - select(0f, (_e12886 * _e12888), (((select(select(_e765, _e926, (_e13486 >= _e691)), _e846, (_e13486 < _e297)) == _e8333) && (_e13484 > 0f)) && (_e13484 < _e13394)))), _e12827, _e12920);
let _e13499 = (_e8337 & 31u);
let _e13501 = (1u << bitcast<u32>(_e13499));
let _e13510 = bitcast<i32>((((_e930 + _e13501) - 1u) >> bitcast<u32>(_e13499)));
let _e13511 = bitcast<i32>((((_e933 + _e13501) - 1u) >> bitcast<u32>(_e13499)));
if _e452 {
phi_33065_ = type_23(_e13511, _e13510);
} else {
phi_33065_ = type_23(_e13510, _e13511);
}
let _e13515 = phi_33065_;
let _e13520 = f32((1i << bitcast<u32>(_e13499)));
let _e13521 = (1f / _e13520);
let _e13523 = ((_e11256 * _e13521) - 0.5f);
let _e13525 = ((_e11350 * _e13521) - 0.5f);
let _e13527 = select(-1f, _e13523, (_e13523 > -1f));
let _e13529 = select(1e6f, _e13527, (_e13527 < 1e6f));
let _e13536 = select(0i, select(select(i32(_e13529), i32(-2147483648), (_e13529 < -2147483600f)), 2147483647i, (_e13529 > 2147483500f)), (_e13529 == _e13529));
let _e13540 = (_e13536 - select(0i, 1i, (_e13529 < f32(_e13536))));
let _e13542 = select(-1f, _e13525, (_e13525 > -1f));
let _e13544 = select(1e6f, _e13542, (_e13542 < 1e6f));
let _e13551 = select(0i, select(select(i32(_e13544), i32(-2147483648), (_e13544 < -2147483600f)), 2147483647i, (_e13544 > 2147483500f)), (_e13544 == _e13544));
let _e13555 = (_e13551 - select(0i, 1i, (_e13544 < f32(_e13551))));
let _e13557 = (_e13523 - f32(_e13540));
let _e13559 = (_e13525 - f32(_e13555));
let _e13560 = (1f - _e13557);
let _e13561 = (1f - _e13559);
let _e13564 = select(_e13540, 0i, (_e13540 < 0i));
let _e13565 = (_e13564 >= _e13515.member);
if _e13565 {
phi_33143_ = (_e13515.member - 1i);
} else {
phi_33143_ = _e13564;
}
let _e13568 = phi_33143_;
let _e13570 = select(_e13555, 0i, (_e13555 < 0i));
let _e13571 = (_e13570 >= _e13515.member_1);
if _e13571 {
phi_33154_ = (_e13515.member_1 - 1i);
} else {
phi_33154_ = _e13570;
}
let _e13574 = phi_33154_;
let _e13578 = (((f32(_e13568) + 0.5f) * _e13520) - 0.5f);
let _e13582 = (((f32(_e13574) + 0.5f) * _e13520) - 0.5f);
if _e452 {
phi_33182_ = type_23(_e13574, _e13568);
} else {
phi_33182_ = type_23(_e13568, _e13574);
}
let _e13588 = phi_33182_;
let _e13591 = (_e8337 == 0u);
if _e13591 {
phi_33233_ = 0u;
} else {
if (_e8337 == 1u) {
phi_33232_ = 0u;
} else {
if (_e8337 == 2u) {
phi_33231_ = _e12241;
} else {
phi_33231_ = select(_e12247, _e12244, (_e8337 == 3u));
}
let _e13597 = phi_33231_;
phi_33232_ = _e13597;
}
let _e13599 = phi_33232_;
phi_33233_ = _e13599;
}
let _e13601 = phi_33233_;
local_86 = (((bitcast<i32>(_e13601) + _e13588.member_1) * _e12238) + _e13588.member);
let _e13606 = local_86;
let _e13608 = select(_e12264, _e13606, (_e13606 < _e12264));
let _e13613 = global_6.member[bitcast<u32>(select(0i, _e13608, (_e13608 > 0i)))];
let _e13618 = (((((select(_e13578, _e13582, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13623 = ((1f - (((select(_e13582, _e13578, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13630 = ((_e11461.member * _e13618) + (_e11469.member * _e13623));
let _e13631 = ((_e11461.member_1 * _e13618) + (_e11469.member_1 * _e13623));
let _e13632 = ((_e11461.member_2 * _e13618) + (_e11469.member_2 * _e13623));
let _e13636 = select((_e11484.member + _e13630), _e11484.member, _e11482);
let _e13637 = select((_e11484.member_1 + _e13631), _e11484.member_1, _e11482);
let _e13638 = select((_e11484.member_2 + _e13632), _e11484.member_2, _e11482);
let _e13649 = (((_e13636 * _e13636) + (_e13637 * _e13637)) + (_e13638 * _e13638));
let _e13653 = (1f / sqrt(select(0f, _e13649, (_e13649 > 0f))));
let _e13654 = (_e13636 * _e13653);
let _e13655 = (_e13637 * _e13653);
let _e13656 = (_e13638 * _e13653);
let _e13657 = (_e574 - select(_e11495.member, (_e11495.member + _e13630), _e11482));
let _e13658 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13631), _e11482));
let _e13659 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13632), _e11482));
let _e13664 = (((_e13657 * _e13654) + (_e13658 * _e13655)) + (_e13659 * _e13656));
let _e13669 = (((_e13657 * _e612) + (_e13658 * _e625)) + (_e13659 * _e638));
let _e13674 = (((_e13654 * _e612) + (_e13655 * _e625)) + (_e13656 * _e638));
let _e13677 = ((_e13655 * _e638) - (_e13656 * _e625));
let _e13680 = ((_e13656 * _e612) - (_e13654 * _e638));
let _e13683 = ((_e13654 * _e625) - (_e13655 * _e612));
let _e13688 = (((_e13677 * _e13677) + (_e13680 * _e13680)) + (_e13683 * _e13683));
let _e13691 = (1f / select(1e-9f, _e13688, (_e13688 > 1e-9f)));
let _e13694 = ((_e13664 - (_e13674 * _e13669)) * _e13691);
let _e13697 = (((_e13674 * _e13664) - _e13669) * _e13691);
let _e13703 = select(0f, _e13694, (((_e13697 >= 0f) && (_e13697 < _e690)) && (_e13694 > 0f)));
let _e13705 = (_e13568 << bitcast<u32>(_e13499));
let _e13717 = (_e13540 + 1i);
let _e13720 = select(_e13717, 0i, (_e13717 < 0i));
let _e13721 = (_e13720 >= _e13515.member);
if _e13721 {
phi_33780_ = (_e13515.member - 1i);
} else {
phi_33780_ = _e13720;
}
let _e13724 = phi_33780_;
if _e13571 {
phi_33791_ = (_e13515.member_1 - 1i);
} else {
phi_33791_ = _e13570;
}
let _e13727 = phi_33791_;
let _e13731 = (((f32(_e13724) + 0.5f) * _e13520) - 0.5f);
let _e13735 = (((f32(_e13727) + 0.5f) * _e13520) - 0.5f);
if _e452 {
phi_33819_ = type_23(_e13727, _e13724);
} else {
phi_33819_ = type_23(_e13724, _e13727);
}
let _e13741 = phi_33819_;
if _e13591 {
phi_33870_ = 0u;
} else {
if (_e8337 == 1u) {
phi_33869_ = 0u;
} else {
if (_e8337 == 2u) {
phi_33868_ = _e12241;
} else {
phi_33868_ = select(_e12247, _e12244, (_e8337 == 3u));
}
let _e13749 = phi_33868_;
phi_33869_ = _e13749;
}
let _e13751 = phi_33869_;
phi_33870_ = _e13751;
}
let _e13753 = phi_33870_;
local_84 = (((bitcast<i32>(_e13753) + _e13741.member_1) * _e12238) + _e13741.member);
let _e13758 = local_84;
let _e13760 = select(_e12264, _e13758, (_e13758 < _e12264));
let _e13765 = global_6.member[bitcast<u32>(select(0i, _e13760, (_e13760 > 0i)))];
let _e13770 = (((((select(_e13731, _e13735, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13775 = ((1f - (((select(_e13735, _e13731, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13782 = ((_e11461.member * _e13770) + (_e11469.member * _e13775));
let _e13783 = ((_e11461.member_1 * _e13770) + (_e11469.member_1 * _e13775));
let _e13784 = ((_e11461.member_2 * _e13770) + (_e11469.member_2 * _e13775));
let _e13788 = select((_e11484.member + _e13782), _e11484.member, _e11482);
let _e13789 = select((_e11484.member_1 + _e13783), _e11484.member_1, _e11482);
let _e13790 = select((_e11484.member_2 + _e13784), _e11484.member_2, _e11482);
let _e13801 = (((_e13788 * _e13788) + (_e13789 * _e13789)) + (_e13790 * _e13790));
let _e13805 = (1f / sqrt(select(0f, _e13801, (_e13801 > 0f))));
let _e13806 = (_e13788 * _e13805);
let _e13807 = (_e13789 * _e13805);
let _e13808 = (_e13790 * _e13805);
let _e13809 = (_e574 - select(_e11495.member, (_e11495.member + _e13782), _e11482));
let _e13810 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13783), _e11482));
let _e13811 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13784), _e11482));
let _e13816 = (((_e13809 * _e13806) + (_e13810 * _e13807)) + (_e13811 * _e13808));
let _e13821 = (((_e13809 * _e612) + (_e13810 * _e625)) + (_e13811 * _e638));
let _e13826 = (((_e13806 * _e612) + (_e13807 * _e625)) + (_e13808 * _e638));
let _e13829 = ((_e13807 * _e638) - (_e13808 * _e625));
let _e13832 = ((_e13808 * _e612) - (_e13806 * _e638));
let _e13835 = ((_e13806 * _e625) - (_e13807 * _e612));
let _e13840 = (((_e13829 * _e13829) + (_e13832 * _e13832)) + (_e13835 * _e13835));
let _e13843 = (1f / select(1e-9f, _e13840, (_e13840 > 1e-9f)));
let _e13846 = ((_e13816 - (_e13826 * _e13821)) * _e13843);
let _e13849 = (((_e13826 * _e13816) - _e13821) * _e13843);
let _e13855 = select(0f, _e13846, (((_e13849 >= 0f) && (_e13849 < _e690)) && (_e13846 > 0f)));
let _e13857 = (_e13724 << bitcast<u32>(_e13499));
let _e13869 = (_e13555 + 1i);
if _e13565 {
phi_34417_ = (_e13515.member - 1i);
} else {
phi_34417_ = _e13564;
}
let _e13873 = phi_34417_;
let _e13875 = select(_e13869, 0i, (_e13869 < 0i));
let _e13876 = (_e13875 >= _e13515.member_1);
if _e13876 {
phi_34428_ = (_e13515.member_1 - 1i);
} else {
phi_34428_ = _e13875;
}
let _e13879 = phi_34428_;
let _e13883 = (((f32(_e13873) + 0.5f) * _e13520) - 0.5f);
let _e13887 = (((f32(_e13879) + 0.5f) * _e13520) - 0.5f);
if _e452 {
phi_34456_ = type_23(_e13879, _e13873);
} else {
phi_34456_ = type_23(_e13873, _e13879);
}
let _e13893 = phi_34456_;
if _e13591 {
phi_34507_ = 0u;
} else {
if (_e8337 == 1u) {
phi_34506_ = 0u;
} else {
if (_e8337 == 2u) {
phi_34505_ = _e12241;
} else {
phi_34505_ = select(_e12247, _e12244, (_e8337 == 3u));
}
let _e13901 = phi_34505_;
phi_34506_ = _e13901;
}
let _e13903 = phi_34506_;
phi_34507_ = _e13903;
}
let _e13905 = phi_34507_;
local_82 = (((bitcast<i32>(_e13905) + _e13893.member_1) * _e12238) + _e13893.member);
let _e13910 = local_82;
let _e13912 = select(_e12264, _e13910, (_e13910 < _e12264));
let _e13917 = global_6.member[bitcast<u32>(select(0i, _e13912, (_e13912 > 0i)))];
let _e13922 = (((((select(_e13883, _e13887, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e13927 = ((1f - (((select(_e13887, _e13883, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e13934 = ((_e11461.member * _e13922) + (_e11469.member * _e13927));
let _e13935 = ((_e11461.member_1 * _e13922) + (_e11469.member_1 * _e13927));
let _e13936 = ((_e11461.member_2 * _e13922) + (_e11469.member_2 * _e13927));
let _e13940 = select((_e11484.member + _e13934), _e11484.member, _e11482);
let _e13941 = select((_e11484.member_1 + _e13935), _e11484.member_1, _e11482);
let _e13942 = select((_e11484.member_2 + _e13936), _e11484.member_2, _e11482);
let _e13953 = (((_e13940 * _e13940) + (_e13941 * _e13941)) + (_e13942 * _e13942));
let _e13957 = (1f / sqrt(select(0f, _e13953, (_e13953 > 0f))));
let _e13958 = (_e13940 * _e13957);
let _e13959 = (_e13941 * _e13957);
let _e13960 = (_e13942 * _e13957);
let _e13961 = (_e574 - select(_e11495.member, (_e11495.member + _e13934), _e11482));
let _e13962 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e13935), _e11482));
let _e13963 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e13936), _e11482));
let _e13968 = (((_e13961 * _e13958) + (_e13962 * _e13959)) + (_e13963 * _e13960));
let _e13973 = (((_e13961 * _e612) + (_e13962 * _e625)) + (_e13963 * _e638));
let _e13978 = (((_e13958 * _e612) + (_e13959 * _e625)) + (_e13960 * _e638));
let _e13981 = ((_e13959 * _e638) - (_e13960 * _e625));
let _e13984 = ((_e13960 * _e612) - (_e13958 * _e638));
let _e13987 = ((_e13958 * _e625) - (_e13959 * _e612));
let _e13992 = (((_e13981 * _e13981) + (_e13984 * _e13984)) + (_e13987 * _e13987));
let _e13995 = (1f / select(1e-9f, _e13992, (_e13992 > 1e-9f)));
let _e13998 = ((_e13968 - (_e13978 * _e13973)) * _e13995);
let _e14001 = (((_e13978 * _e13968) - _e13973) * _e13995);
let _e14007 = select(0f, _e13998, (((_e14001 >= 0f) && (_e14001 < _e690)) && (_e13998 > 0f)));
let _e14009 = (_e13873 << bitcast<u32>(_e13499));
if _e13721 {
phi_35054_ = (_e13515.member - 1i);
} else {
phi_35054_ = _e13720;
}
let _e14024 = phi_35054_;
if _e13876 {
phi_35065_ = (_e13515.member_1 - 1i);
} else {
phi_35065_ = _e13875;
}
let _e14027 = phi_35065_;
let _e14031 = (((f32(_e14024) + 0.5f) * _e13520) - 0.5f);
let _e14035 = (((f32(_e14027) + 0.5f) * _e13520) - 0.5f);
if _e452 {
phi_35093_ = type_23(_e14027, _e14024);
} else {
phi_35093_ = type_23(_e14024, _e14027);
}
let _e14041 = phi_35093_;
if _e13591 {
phi_35144_ = 0u;
} else {
if (_e8337 == 1u) {
phi_35143_ = 0u;
} else {
if (_e8337 == 2u) {
phi_35142_ = _e12241;
} else {
phi_35142_ = select(_e12247, _e12244, (_e8337 == 3u));
}
let _e14049 = phi_35142_;
phi_35143_ = _e14049;
}
let _e14051 = phi_35143_;
phi_35144_ = _e14051;
}
let _e14053 = phi_35144_;
local_80 = (((bitcast<i32>(_e14053) + _e14041.member_1) * _e12238) + _e14041.member);
let _e14058 = local_80;
let _e14060 = select(_e12264, _e14058, (_e14058 < _e12264));
let _e14065 = global_6.member[bitcast<u32>(select(0i, _e14060, (_e14060 > 0i)))];
let _e14070 = (((((select(_e14031, _e14035, _e452) + 0.5f) / _e11442) * 2f) - 1f) * _e11450);
let _e14075 = ((1f - (((select(_e14035, _e14031, _e452) + 0.5f) / _e11443) * 2f)) * _e11458);
let _e14082 = ((_e11461.member * _e14070) + (_e11469.member * _e14075));
let _e14083 = ((_e11461.member_1 * _e14070) + (_e11469.member_1 * _e14075));
let _e14084 = ((_e11461.member_2 * _e14070) + (_e11469.member_2 * _e14075));
let _e14088 = select((_e11484.member + _e14082), _e11484.member, _e11482);
let _e14089 = select((_e11484.member_1 + _e14083), _e11484.member_1, _e11482);
let _e14090 = select((_e11484.member_2 + _e14084), _e11484.member_2, _e11482);
let _e14101 = (((_e14088 * _e14088) + (_e14089 * _e14089)) + (_e14090 * _e14090));
let _e14105 = (1f / sqrt(select(0f, _e14101, (_e14101 > 0f))));
let _e14106 = (_e14088 * _e14105);
let _e14107 = (_e14089 * _e14105);
let _e14108 = (_e14090 * _e14105);
let _e14109 = (_e574 - select(_e11495.member, (_e11495.member + _e14082), _e11482));
let _e14110 = (_e586 - select(_e11495.member_1, (_e11495.member_1 + _e14083), _e11482));
let _e14111 = (_e599 - select(_e11495.member_2, (_e11495.member_2 + _e14084), _e11482));
let _e14116 = (((_e14109 * _e14106) + (_e14110 * _e14107)) + (_e14111 * _e14108));
let _e14121 = (((_e14109 * _e612) + (_e14110 * _e625)) + (_e14111 * _e638));
let _e14126 = (((_e14106 * _e612) + (_e14107 * _e625)) + (_e14108 * _e638));
let _e14129 = ((_e14107 * _e638) - (_e14108 * _e625));
let _e14132 = ((_e14108 * _e612) - (_e14106 * _e638));
let _e14135 = ((_e14106 * _e625) - (_e14107 * _e612));
let _e14140 = (((_e14129 * _e14129) + (_e14132 * _e14132)) + (_e14135 * _e14135));
let _e14143 = (1f / select(1e-9f, _e14140, (_e14140 > 1e-9f)));
let _e14146 = ((_e14116 - (_e14126 * _e14121)) * _e14143);
let _e14149 = (((_e14126 * _e14116) - _e14121) * _e14143);
let _e14155 = select(0f, _e14146, (((_e14149 >= 0f) && (_e14149 < _e690)) && (_e14146 > 0f)));
let _e14157 = (_e14024 << bitcast<u32>(_e13499));
let _e14169 = select(((((_e13498 - select(0f, (_e13560 * _e13561), (((select(select(_e765, _e926, (_e13705 >= _e691)), _e846, (_e13705 < _e297)) == _e8337) && (_e13703 > 0f)) && (_e13703 < _e13613)))) - select(0f, (_e13557 * _e13561), (((select(select(_e765, _e926, (_e13857 >= _e691)), _e846, (_e13857 < _e297)) == _e8337) && (_e13855 > 0f)) && (_e13855 < _e13765)))) - select(0f, (_e13560 * _e13559), (((select(select(_e765, _e926, (_e14009 >= _e691)), _e846, (_e14009 < _e297)) == _e8337) && (_e14007 > 0f)) && (_e14007 < _e13917)))) - select(0f, (_e13557 * _e13559), (((select(select(_e765, _e926, (_e14157 >= _e691)), _e846, (_e14157 < _e297)) == _e8337) && (_e14155 > 0f)) && (_e14155 < _e14065)))), _e13498, _e13591);
if _e452 {
phi_35700_ = type_23(_e11347, _e11254);
} else {
phi_35700_ = type_23(_e11254, _e11347);
}
let _e14184 = phi_35700_;
let _e14187 = (_e11348 && (((_e12155 > 0f) && (_e12155 < _e11438)) && (bitcast<f32>((bitcast<u32>(_e14169) & 2147483647u)) > 1e-6f)));
let _e14190 = global_1.member.member_18.member;
let _e14191 = (((select(_e11373, (1f - _e11373), (_e11358 >= 0f)) - select(_e11392, (1f - _e11392), (_e11377 >= 0f))) * (1f / _e11355)) * _e14190);
let _e14195 = select(0f, (((((_e651 * _e11992.member) * ((1f + (_e12032 * (1f + (_e12032 * (0.5f + (_e12032 * (0.16666667f + (_e12032 * (0.041666668f + (_e12032 * (0.008333334f + (_e12032 * (0.001388889f + (_e12032 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12027 + 127i)) << bitcast<u32>(23i))))) * _e11989) * _e14169) * _e14191), _e14187);
let _e14196 = select(0f, (((((_e664 * _e11992.member_1) * ((1f + (_e12080 * (1f + (_e12080 * (0.5f + (_e12080 * (0.16666667f + (_e12080 * (0.041666668f + (_e12080 * (0.008333334f + (_e12080 * (0.001388889f + (_e12080 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12075 + 127i)) << bitcast<u32>(23i))))) * _e11989) * _e14169) * _e14191), _e14187);
let _e14197 = select(0f, (((((_e677 * _e11992.member_2) * ((1f + (_e12128 * (1f + (_e12128 * (0.5f + (_e12128 * (0.16666667f + (_e12128 * (0.041666668f + (_e12128 * (0.008333334f + (_e12128 * (0.001388889f + (_e12128 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e12123 + 127i)) << bitcast<u32>(23i))))) * _e11989) * _e14169) * _e14191), _e14187);
let _e14201 = (bitcast<f32>((bitcast<u32>(_e14195) & 2147483647u)) >= 1073741800f);
let _e14202 = (1f / 1048576f);
let _e14205 = ((_e14195 * select(1f, _e14202, _e14201)) + 0.5f);
let _e14207 = select(-1073741800f, _e14205, (_e14205 > -1073741800f));
let _e14209 = select(1073741800f, _e14207, (_e14207 < 1073741800f));
let _e14216 = select(0i, select(select(i32(_e14209), i32(-2147483648), (_e14209 < -2147483600f)), 2147483647i, (_e14209 > 2147483500f)), (_e14209 == _e14209));
let _e14220 = (_e14216 - select(0i, 1i, (_e14209 < f32(_e14216))));
let _e14221 = select(0i, 20i, _e14201);
let _e14225 = (bitcast<u32>(_e14220) << bitcast<u32>((_e14221 & 31i)));
let _e14232 = bitcast<u32>(((_e14220 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14221) & 31i))));
let _e14236 = (bitcast<f32>((bitcast<u32>(_e14196) & 2147483647u)) >= 1073741800f);
let _e14239 = ((_e14196 * select(1f, _e14202, _e14236)) + 0.5f);
let _e14241 = select(-1073741800f, _e14239, (_e14239 > -1073741800f));
let _e14243 = select(1073741800f, _e14241, (_e14241 < 1073741800f));
let _e14250 = select(0i, select(select(i32(_e14243), i32(-2147483648), (_e14243 < -2147483600f)), 2147483647i, (_e14243 > 2147483500f)), (_e14243 == _e14243));
let _e14254 = (_e14250 - select(0i, 1i, (_e14243 < f32(_e14250))));
let _e14255 = select(0i, 20i, _e14236);
let _e14259 = (bitcast<u32>(_e14254) << bitcast<u32>((_e14255 & 31i)));
let _e14266 = bitcast<u32>(((_e14254 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14255) & 31i))));
let _e14270 = (bitcast<f32>((bitcast<u32>(_e14197) & 2147483647u)) >= 1073741800f);
let _e14273 = ((_e14197 * select(1f, _e14202, _e14270)) + 0.5f);
let _e14275 = select(-1073741800f, _e14273, (_e14273 > -1073741800f));
let _e14277 = select(1073741800f, _e14275, (_e14275 < 1073741800f));
let _e14284 = select(0i, select(select(i32(_e14277), i32(-2147483648), (_e14277 < -2147483600f)), 2147483647i, (_e14277 > 2147483500f)), (_e14277 == _e14277));
let _e14288 = (_e14284 - select(0i, 1i, (_e14277 < f32(_e14284))));
let _e14289 = select(0i, 20i, _e14270);
let _e14293 = (bitcast<u32>(_e14288) << bitcast<u32>((_e14289 & 31i)));
let _e14300 = bitcast<u32>(((_e14288 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14289) & 31i))));
let _e14305 = bitcast<i32>(bitcast<u32>((((_e14184.member_1 * _e934) + _e14184.member) * 6i)));
if ((_e14225 | _e14232) == 0u) {
} else {
let _e14308 = bitcast<u32>(_e14305);
if (_e14308 < _e269) {
let _e14312 = atomicAdd((&global_8.member[_e14308]), _e14225);
phi_35933_ = _e14312;
} else {
phi_35933_ = 0u;
}
let _e14314 = phi_35933_;
let _e14318 = (_e14232 + select(0u, 1u, ((_e14314 + _e14225) < _e14225)));
if (_e14318 == 0u) {
} else {
let _e14320 = (_e14308 + 1u);
if (_e14320 < _e269) {
let _e14324 = atomicAdd((&global_8.member[_e14320]), _e14318);
}
}
}
if ((_e14259 | _e14266) == 0u) {
} else {
let _e14328 = bitcast<u32>((_e14305 + 2i));
if (_e14328 < _e269) {
let _e14332 = atomicAdd((&global_8.member[_e14328]), _e14259);
phi_35963_ = _e14332;
} else {
phi_35963_ = 0u;
}
let _e14334 = phi_35963_;
let _e14338 = (_e14266 + select(0u, 1u, ((_e14334 + _e14259) < _e14259)));
if (_e14338 == 0u) {
} else {
let _e14340 = (_e14328 + 1u);
if (_e14340 < _e269) {
let _e14344 = atomicAdd((&global_8.member[_e14340]), _e14338);
}
}
}
if ((_e14293 | _e14300) == 0u) {
} else {
let _e14348 = bitcast<u32>((_e14305 + 4i));
if (_e14348 < _e269) {
let _e14352 = atomicAdd((&global_8.member[_e14348]), _e14293);
phi_35993_ = _e14352;
} else {
phi_35993_ = 0u;
}
let _e14354 = phi_35993_;
let _e14358 = (_e14300 + select(0u, 1u, ((_e14354 + _e14293) < _e14293)));
if (_e14358 == 0u) {
} else {
let _e14360 = (_e14348 + 1u);
if (_e14360 < _e269) {
let _e14364 = atomicAdd((&global_8.member[_e14360]), _e14358);
}
}
}
phi_26499_ = (_e11345 + 1i);
} else {
phi_26499_ = i32();
}
let _e14367 = phi_26499_;
continue;
continuing {
phi_26498_ = _e14367;
break if !(_e11348);
}
}
phi_26345_ = (_e11251 + 1i);
} else {
phi_26345_ = i32();
}
let _e14371 = phi_26345_;
continue;
continuing {
phi_26344_ = _e14371;
break if !(_e11252);
}
}
}
}
}
}
} else {
let _e14375 = global_1.member.member_1.member;
let _e14378 = global_1.member.member_1.member_1;
let _e14379 = bitcast<i32>(_e14375);
let _e14380 = bitcast<i32>(_e14378);
if _e452 {
phi_36060_ = type_23(_e14380, _e14379);
} else {
phi_36060_ = type_23(_e14379, _e14380);
}
let _e14384 = phi_36060_;
let _e14388 = f32((_e297 + 15i));
let _e14390 = select(_e14388, _e377, (_e377 < _e14388));
let _e14392 = select(_e313, _e14390, (_e14390 > _e313));
let _e14394 = select(_e14388, _e14392, (_e14392 < _e14388));
let _e14401 = select(0i, select(select(i32(_e14394), i32(-2147483648), (_e14394 < -2147483600f)), 2147483647i, (_e14394 > 2147483500f)), (_e14394 == _e14394));
let _e14405 = (_e14401 - select(0i, 1i, (_e14394 < f32(_e14401))));
let _e14406 = bitcast<i32>(_e14405);
let _e14408 = select(_e313, _e364, (_e364 > _e313));
let _e14410 = select(_e313, _e14408, (_e14408 > _e313));
let _e14412 = select(_e14388, _e14410, (_e14410 < _e14388));
let _e14419 = select(0i, select(select(i32(_e14412), i32(-2147483648), (_e14412 < -2147483600f)), 2147483647i, (_e14412 > 2147483500f)), (_e14412 == _e14412));
let _e14423 = (_e14419 - select(0i, 1i, (_e14412 < f32(_e14419))));
let _e14424 = bitcast<i32>(_e14423);
if (_e14406 < _e14384.member) {
phi_36135_ = _e14406;
} else {
phi_36135_ = (_e14384.member - 1i);
}
let _e14428 = phi_36135_;
let _e14429 = (_e14384.member_1 - 1i);
let _e14430 = (_e765 == 0u);
if _e14430 {
let _e14432 = select(_e846, 0u, (_e846 == _e765));
let _e14436 = select(_e926, 0u, ((_e926 == _e765) || (_e926 == _e846)));
let _e14444 = ((select(0u, 1u, (_e765 > 0u)) + select(0u, 1u, (_e14432 > 0u))) + select(0u, 1u, (_e14436 > 0u)));
if (_e14444 == 0u) {
phi_36173_ = 0i;
loop {
let _e14447 = phi_36173_;
let _e14448 = (_e14447 < 16i);
if _e14448 {
let _e14450 = (_e14424 + (_e14447 & 15i));
let _e14454 = (((f32(_e14450) + 0.5f) * 1f) - 0.5f);
let _e14458 = (-(((_e415 * _e14454) + _e441)) / _e428);
let _e14465 = bitcast<f32>((bitcast<u32>(((_e465 * _e14454) + ((_e478 * _e14458) + _e491))) & 2147483647u));
let _e14472 = bitcast<f32>((bitcast<u32>(((_e504 * _e14454) + ((_e517 * _e14458) + _e530))) & 2147483647u));
let _e14476 = (((0.5f * (_e14465 + _e14472)) / _e533) + _e716);
let _e14477 = (1f / 1f);
let _e14485 = ((((_e14458 + _e14476) + 0.5f) * _e14477) - 0.5f);
let _e14486 = f32(_e14429);
let _e14487 = (0f - 1f);
let _e14489 = select(_e14487, _e14485, (_e14485 > _e14487));
let _e14491 = select(_e14486, _e14489, (_e14489 < _e14486));
let _e14498 = select(0i, select(select(i32(_e14491), i32(-2147483648), (_e14491 < -2147483600f)), 2147483647i, (_e14491 > 2147483500f)), (_e14491 == _e14491));
let _e14503 = (((((_e14458 - _e14476) + 0.5f) * _e14477) - 0.5f) + 1f);
let _e14504 = (_e14486 + 1f);
let _e14506 = select(0f, _e14503, (_e14503 > 0f));
let _e14508 = select(_e14504, _e14506, (_e14506 < _e14504));
let _e14515 = select(0i, select(select(i32(_e14508), i32(-2147483648), (_e14508 < -2147483600f)), 2147483647i, (_e14508 > 2147483500f)), (_e14508 == _e14508));
let _e14526 = ((1e-4f * 1f) * _e533);
let _e14528 = select(_e14472, _e14465, (_e14465 > _e14472));
let _e14530 = select(_e14526, _e14528, (_e14528 > _e14526));
let _e14532 = select(_e14472, _e14465, (_e14465 < _e14472));
let _e14534 = select(_e14526, _e14532, (_e14532 > _e14526));
let _e14536 = (0.5f * (_e14530 + _e14534));
let _e14537 = (0.5f / _e14534);
let _e14538 = (1f / _e14530);
phi_36327_ = 0i;
loop {
let _e14540 = phi_36327_;
let _e14542 = (((_e14515 - select(0i, 1i, (_e14508 < f32(_e14515)))) + (_e14447 >> bitcast<u32>(4u))) + bitcast<i32>(_e14540));
let _e14543 = (_e14542 <= select(-1i, (_e14498 - select(0i, 1i, (_e14491 < f32(_e14498)))), (_e14450 <= _e14428)));
if _e14543 {
let _e14549 = (((((f32(_e14542) + 0.5f) * 1f) - 0.5f) - _e14458) * _e533);
let _e14550 = (_e533 * 1f);
let _e14552 = (0.5f * _e14550);
let _e14553 = (_e14549 + _e14552);
let _e14554 = -(_e14553);
let _e14557 = (_e14536 - select(_e14554, _e14553, (_e14553 > _e14554)));
let _e14559 = select(0f, _e14557, (_e14557 > 0f));
let _e14561 = select(_e14534, _e14559, (_e14559 < _e14534));
let _e14564 = (_e14557 - _e14534);
let _e14568 = (((_e14561 * (_e14561 * _e14537)) + select(0f, _e14564, (_e14564 > 0f))) * _e14538);
let _e14572 = (_e14549 - _e14552);
let _e14573 = -(_e14572);
let _e14576 = (_e14536 - select(_e14573, _e14572, (_e14572 > _e14573)));
let _e14578 = select(0f, _e14576, (_e14576 > 0f));
let _e14580 = select(_e14534, _e14578, (_e14578 < _e14534));
let _e14583 = (_e14576 - _e14534);
let _e14587 = (((_e14580 * (_e14580 * _e14537)) + select(0f, _e14583, (_e14583 > 0f))) * _e14538);
if _e452 {
phi_36432_ = type_23(_e14542, _e14450);
} else {
phi_36432_ = type_23(_e14450, _e14542);
}
let _e14596 = phi_36432_;
local_78 = bitcast<i32>((_e14375 * _e14378));
local_79 = ((_e14596.member_1 * _e14379) + _e14596.member);
let _e14603 = local_78;
let _e14604 = local_79;
let _e14605 = (_e14603 + _e14604);
let _e14607 = (bitcast<i32>(_e258) - 1i);
let _e14609 = select(_e14607, _e14605, (_e14605 < _e14607));
let _e14614 = global_5.member[bitcast<u32>(select(0i, _e14609, (_e14609 > 0i)))];
let _e14615 = local_79;
let _e14617 = select(_e14607, _e14615, (_e14615 < _e14607));
let _e14622 = global_5.member[bitcast<u32>(select(0i, _e14617, (_e14617 > 0i)))];
let _e14633 = global_1.member.member_2.member;
let _e14634 = (((((f32(_e14596.member) + 0.5f) / f32(_e14379)) * 2f) - 1f) * _e14633);
let _e14641 = global_1.member.member_2.member_1;
let _e14642 = ((1f - (((f32(_e14596.member_1) + 0.5f) / f32(_e14380)) * 2f)) * _e14641);
let _e14644 = global_1.member.member_3;
let _e14652 = global_1.member.member_4;
let _e14659 = ((_e14644.member * _e14634) + (_e14652.member * _e14642));
let _e14660 = ((_e14644.member_1 * _e14634) + (_e14652.member_1 * _e14642));
let _e14661 = ((_e14644.member_2 * _e14634) + (_e14652.member_2 * _e14642));
let _e14664 = global_1.member.member_2.member_3;
let _e14665 = (_e14664 != 0u);
let _e14667 = global_1.member.member_5;
let _e14674 = select((_e14667.member + _e14659), _e14667.member, _e14665);
let _e14675 = select((_e14667.member_1 + _e14660), _e14667.member_1, _e14665);
let _e14676 = select((_e14667.member_2 + _e14661), _e14667.member_2, _e14665);
let _e14678 = global_1.member.member_6;
let _e14692 = (((_e14674 * _e14674) + (_e14675 * _e14675)) + (_e14676 * _e14676));
let _e14695 = sqrt(select(0f, _e14692, (_e14692 > 0f)));
let _e14696 = (1f / _e14695);
let _e14697 = (_e14674 * _e14696);
let _e14698 = (_e14675 * _e14696);
let _e14699 = (_e14676 * _e14696);
let _e14700 = (_e574 - select(_e14678.member, (_e14678.member + _e14659), _e14665));
let _e14701 = (_e586 - select(_e14678.member_1, (_e14678.member_1 + _e14660), _e14665));
let _e14702 = (_e599 - select(_e14678.member_2, (_e14678.member_2 + _e14661), _e14665));
let _e14707 = (((_e14700 * _e14697) + (_e14701 * _e14698)) + (_e14702 * _e14699));
let _e14712 = (((_e14700 * _e612) + (_e14701 * _e625)) + (_e14702 * _e638));
let _e14717 = (((_e14697 * _e612) + (_e14698 * _e625)) + (_e14699 * _e638));
let _e14720 = ((_e14698 * _e638) - (_e14699 * _e625));
let _e14723 = ((_e14699 * _e612) - (_e14697 * _e638));
let _e14726 = ((_e14697 * _e625) - (_e14698 * _e612));
let _e14731 = (((_e14720 * _e14720) + (_e14723 * _e14723)) + (_e14726 * _e14726));
let _e14734 = (1f / select(1e-9f, _e14731, (_e14731 > 1e-9f)));
let _e14737 = ((_e14707 - (_e14717 * _e14712)) * _e14734);
let _e14740 = (((_e14717 * _e14707) - _e14712) * _e14734);
let _e14746 = -(_e14717);
let _e14749 = global_1.member.member_13.member_2;
let _e14750 = (_e14749 * _e14749);
let _e14754 = ((1f + _e14750) - ((2f * _e14749) * _e14746));
let _e14756 = select(1e-9f, _e14754, (_e14754 > 1e-9f));
let _e14768 = global_1.member.member_13.member_3;
let _e14773 = (_e14695 * (select(((1f - _e14750) / (_e14756 * sqrt(select(0f, _e14756, (_e14756 > 0f))))), (0.75f * (1f + (_e14746 * _e14746))), (_e14768 == 1u)) * (0.25f / 3.1415927f)));
let _e14774 = (_e14737 - _e14614);
let _e14777 = (_e14740 + select(0f, _e14774, (_e14774 > 0f)));
let _e14780 = global_1.member.member_13.member_1;
let _e14789 = global_1.member.member_13.member;
let _e14794 = -((_e14789.member * _e14777));
let _e14796 = select(-87f, _e14794, (_e14794 > -87f));
let _e14798 = select(88f, _e14796, (_e14796 < 88f));
let _e14800 = ((_e14798 * 1.442695f) + 0.5f);
let _e14802 = select(-127f, _e14800, (_e14800 > -127f));
let _e14804 = select(128f, _e14802, (_e14802 < 128f));
let _e14811 = select(0i, select(select(i32(_e14804), i32(-2147483648), (_e14804 < -2147483600f)), 2147483647i, (_e14804 > 2147483500f)), (_e14804 == _e14804));
let _e14815 = (_e14811 - select(0i, 1i, (_e14804 < f32(_e14811))));
let _e14816 = f32(_e14815);
let _e14820 = ((_e14798 - (_e14816 * 0.6933594f)) - (_e14816 * -2.1219444e-4f));
let _e14842 = -((_e14789.member_1 * _e14777));
let _e14844 = select(-87f, _e14842, (_e14842 > -87f));
let _e14846 = select(88f, _e14844, (_e14844 < 88f));
let _e14848 = ((_e14846 * 1.442695f) + 0.5f);
let _e14850 = select(-127f, _e14848, (_e14848 > -127f));
let _e14852 = select(128f, _e14850, (_e14850 < 128f));
let _e14859 = select(0i, select(select(i32(_e14852), i32(-2147483648), (_e14852 < -2147483600f)), 2147483647i, (_e14852 > 2147483500f)), (_e14852 == _e14852));
let _e14863 = (_e14859 - select(0i, 1i, (_e14852 < f32(_e14859))));
let _e14864 = f32(_e14863);
let _e14868 = ((_e14846 - (_e14864 * 0.6933594f)) - (_e14864 * -2.1219444e-4f));
let _e14890 = -((_e14789.member_2 * _e14777));
let _e14892 = select(-87f, _e14890, (_e14890 > -87f));
let _e14894 = select(88f, _e14892, (_e14892 < 88f));
let _e14896 = ((_e14894 * 1.442695f) + 0.5f);
let _e14898 = select(-127f, _e14896, (_e14896 > -127f));
let _e14900 = select(128f, _e14898, (_e14898 < 128f));
let _e14907 = select(0i, select(select(i32(_e14900), i32(-2147483648), (_e14900 < -2147483600f)), 2147483647i, (_e14900 > 2147483500f)), (_e14900 == _e14900));
let _e14911 = (_e14907 - select(0i, 1i, (_e14900 < f32(_e14907))));
let _e14912 = f32(_e14911);
let _e14916 = ((_e14894 - (_e14912 * 0.6933594f)) - (_e14912 * -2.1219444e-4f));
let _e14943 = select(0f, _e14737, (((_e14740 >= 0f) && (_e14740 < _e690)) && (_e14737 > 0f)));
if _e452 {
phi_36984_ = type_23(_e14542, _e14450);
} else {
phi_36984_ = type_23(_e14450, _e14542);
}
let _e14954 = phi_36984_;
let _e14957 = (_e14543 && (((_e14943 > 0f) && (_e14943 < _e14622)) && true));
let _e14960 = global_1.member.member_18.member;
let _e14961 = (((select(_e14568, (1f - _e14568), (_e14553 >= 0f)) - select(_e14587, (1f - _e14587), (_e14572 >= 0f))) * (1f / _e14550)) * _e14960);
let _e14965 = select(0f, (((((_e651 * _e14780.member) * ((1f + (_e14820 * (1f + (_e14820 * (0.5f + (_e14820 * (0.16666667f + (_e14820 * (0.041666668f + (_e14820 * (0.008333334f + (_e14820 * (0.001388889f + (_e14820 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14815 + 127i)) << bitcast<u32>(23i))))) * _e14773) * 1f) * _e14961), _e14957);
let _e14966 = select(0f, (((((_e664 * _e14780.member_1) * ((1f + (_e14868 * (1f + (_e14868 * (0.5f + (_e14868 * (0.16666667f + (_e14868 * (0.041666668f + (_e14868 * (0.008333334f + (_e14868 * (0.001388889f + (_e14868 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14863 + 127i)) << bitcast<u32>(23i))))) * _e14773) * 1f) * _e14961), _e14957);
let _e14967 = select(0f, (((((_e677 * _e14780.member_2) * ((1f + (_e14916 * (1f + (_e14916 * (0.5f + (_e14916 * (0.16666667f + (_e14916 * (0.041666668f + (_e14916 * (0.008333334f + (_e14916 * (0.001388889f + (_e14916 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e14911 + 127i)) << bitcast<u32>(23i))))) * _e14773) * 1f) * _e14961), _e14957);
let _e14971 = (bitcast<f32>((bitcast<u32>(_e14965) & 2147483647u)) >= 1073741800f);
let _e14972 = (1f / 1048576f);
let _e14975 = ((_e14965 * select(1f, _e14972, _e14971)) + 0.5f);
let _e14977 = select(-1073741800f, _e14975, (_e14975 > -1073741800f));
let _e14979 = select(1073741800f, _e14977, (_e14977 < 1073741800f));
let _e14986 = select(0i, select(select(i32(_e14979), i32(-2147483648), (_e14979 < -2147483600f)), 2147483647i, (_e14979 > 2147483500f)), (_e14979 == _e14979));
let _e14990 = (_e14986 - select(0i, 1i, (_e14979 < f32(_e14986))));
let _e14991 = select(0i, 20i, _e14971);
let _e14995 = (bitcast<u32>(_e14990) << bitcast<u32>((_e14991 & 31i)));
let _e15002 = bitcast<u32>(((_e14990 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e14991) & 31i))));
let _e15006 = (bitcast<f32>((bitcast<u32>(_e14966) & 2147483647u)) >= 1073741800f);
let _e15009 = ((_e14966 * select(1f, _e14972, _e15006)) + 0.5f);
let _e15011 = select(-1073741800f, _e15009, (_e15009 > -1073741800f));
let _e15013 = select(1073741800f, _e15011, (_e15011 < 1073741800f));
let _e15020 = select(0i, select(select(i32(_e15013), i32(-2147483648), (_e15013 < -2147483600f)), 2147483647i, (_e15013 > 2147483500f)), (_e15013 == _e15013));
let _e15024 = (_e15020 - select(0i, 1i, (_e15013 < f32(_e15020))));
let _e15025 = select(0i, 20i, _e15006);
let _e15029 = (bitcast<u32>(_e15024) << bitcast<u32>((_e15025 & 31i)));
let _e15036 = bitcast<u32>(((_e15024 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15025) & 31i))));
let _e15040 = (bitcast<f32>((bitcast<u32>(_e14967) & 2147483647u)) >= 1073741800f);
let _e15043 = ((_e14967 * select(1f, _e14972, _e15040)) + 0.5f);
let _e15045 = select(-1073741800f, _e15043, (_e15043 > -1073741800f));
let _e15047 = select(1073741800f, _e15045, (_e15045 < 1073741800f));
let _e15054 = select(0i, select(select(i32(_e15047), i32(-2147483648), (_e15047 < -2147483600f)), 2147483647i, (_e15047 > 2147483500f)), (_e15047 == _e15047));
let _e15058 = (_e15054 - select(0i, 1i, (_e15047 < f32(_e15054))));
let _e15059 = select(0i, 20i, _e15040);
let _e15063 = (bitcast<u32>(_e15058) << bitcast<u32>((_e15059 & 31i)));
let _e15070 = bitcast<u32>(((_e15058 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e15059) & 31i))));
let _e15075 = bitcast<i32>(bitcast<u32>((((_e14954.member_1 * _e14379) + _e14954.member) * 6i)));
if ((_e14995 | _e15002) == 0u) {
} else {
let _e15078 = bitcast<u32>(_e15075);
if (_e15078 < _e269) {
let _e15082 = atomicAdd((&global_8.member[_e15078]), _e14995);
phi_37217_ = _e15082;
} else {
phi_37217_ = 0u;
}
let _e15084 = phi_37217_;
let _e15088 = (_e15002 + select(0u, 1u, ((_e15084 + _e14995) < _e14995)));
if (_e15088 == 0u) {
} else {
let _e15090 = (_e15078 + 1u);
if (_e15090 < _e269) {
let _e15094 = atomicAdd((&global_8.member[_e15090]), _e15088);
}
}
}
if ((_e15029 | _e15036) == 0u) {
} else {
let _e15098 = bitcast<u32>((_e15075 + 2i));
if (_e15098 < _e269) {
let _e15102 = atomicAdd((&global_8.member[_e15098]), _e15029);
phi_37247_ = _e15102;
} else {
phi_37247_ = 0u;
}
let _e15104 = phi_37247_;
let _e15108 = (_e15036 + select(0u, 1u, ((_e15104 + _e15029) < _e15029)));
if (_e15108 == 0u) {
} else {
let _e15110 = (_e15098 + 1u);
if (_e15110 < _e269) {
let _e15114 = atomicAdd((&global_8.member[_e15110]), _e15108);
}
}
}
if ((_e15063 | _e15070) == 0u) {
} else {
let _e15118 = bitcast<u32>((_e15075 + 4i));
if (_e15118 < _e269) {
let _e15122 = atomicAdd((&global_8.member[_e15118]), _e15063);
phi_37277_ = _e15122;
} else {
phi_37277_ = 0u;
}
let _e15124 = phi_37277_;
let _e15128 = (_e15070 + select(0u, 1u, ((_e15124 + _e15063) < _e15063)));
if (_e15128 == 0u) {
} else {
let _e15130 = (_e15118 + 1u);
if (_e15130 < _e269) {
let _e15134 = atomicAdd((&global_8.member[_e15130]), _e15128);
}
}
}
phi_36328_ = (_e14540 + 1i);
} else {
phi_36328_ = i32();
}
let _e15137 = phi_36328_;
continue;
continuing {
phi_36327_ = _e15137;
break if !(_e14543);
}
}
phi_36174_ = (_e14447 + 1i);
} else {
phi_36174_ = i32();
}
let _e15141 = phi_36174_;
continue;
continuing {
phi_36173_ = _e15141;
break if !(_e14448);
}
}
} else {
if (_e14444 == 1u) {
phi_37326_ = 0i;
loop {
let _e15145 = phi_37326_;
let _e15146 = (_e15145 < 16i);
if _e15146 {
let _e15148 = (_e14424 + (_e15145 & 15i));
let _e15150 = (f32(_e15148) + 0.5f);
let _e15152 = ((_e15150 * 1f) - 0.5f);
let _e15156 = (-(((_e415 * _e15152) + _e441)) / _e428);
let _e15163 = bitcast<f32>((bitcast<u32>(((_e465 * _e15152) + ((_e478 * _e15156) + _e491))) & 2147483647u));
let _e15170 = bitcast<f32>((bitcast<u32>(((_e504 * _e15152) + ((_e517 * _e15156) + _e530))) & 2147483647u));
let _e15174 = (((0.5f * (_e15163 + _e15170)) / _e533) + _e716);
let _e15175 = (1f / 1f);
let _e15183 = ((((_e15156 + _e15174) + 0.5f) * _e15175) - 0.5f);
let _e15184 = f32(_e14429);
let _e15185 = (0f - 1f);
let _e15187 = select(_e15185, _e15183, (_e15183 > _e15185));
let _e15189 = select(_e15184, _e15187, (_e15187 < _e15184));
let _e15196 = select(0i, select(select(i32(_e15189), i32(-2147483648), (_e15189 < -2147483600f)), 2147483647i, (_e15189 > 2147483500f)), (_e15189 == _e15189));
let _e15201 = (((((_e15156 - _e15174) + 0.5f) * _e15175) - 0.5f) + 1f);
let _e15202 = (_e15184 + 1f);
let _e15204 = select(0f, _e15201, (_e15201 > 0f));
let _e15206 = select(_e15202, _e15204, (_e15204 < _e15202));
let _e15213 = select(0i, select(select(i32(_e15206), i32(-2147483648), (_e15206 < -2147483600f)), 2147483647i, (_e15206 > 2147483500f)), (_e15206 == _e15206));
let _e15224 = ((1e-4f * 1f) * _e533);
let _e15226 = select(_e15170, _e15163, (_e15163 > _e15170));
let _e15228 = select(_e15224, _e15226, (_e15226 > _e15224));
let _e15230 = select(_e15170, _e15163, (_e15163 < _e15170));
let _e15232 = select(_e15224, _e15230, (_e15230 > _e15224));
let _e15234 = (0.5f * (_e15228 + _e15232));
let _e15235 = (0.5f / _e15232);
let _e15236 = (1f / _e15228);
phi_37480_ = 0i;
loop {
let _e15238 = phi_37480_;
let _e15240 = (((_e15213 - select(0i, 1i, (_e15206 < f32(_e15213)))) + (_e15145 >> bitcast<u32>(4u))) + bitcast<i32>(_e15238));
let _e15241 = (_e15240 <= select(-1i, (_e15196 - select(0i, 1i, (_e15189 < f32(_e15196)))), (_e15148 <= _e14428)));
if _e15241 {
let _e15243 = (f32(_e15240) + 0.5f);
let _e15247 = ((((_e15243 * 1f) - 0.5f) - _e15156) * _e533);
let _e15248 = (_e533 * 1f);
let _e15250 = (0.5f * _e15248);
let _e15251 = (_e15247 + _e15250);
let _e15252 = -(_e15251);
let _e15255 = (_e15234 - select(_e15252, _e15251, (_e15251 > _e15252)));
let _e15257 = select(0f, _e15255, (_e15255 > 0f));
let _e15259 = select(_e15232, _e15257, (_e15257 < _e15232));
let _e15262 = (_e15255 - _e15232);
let _e15266 = (((_e15259 * (_e15259 * _e15235)) + select(0f, _e15262, (_e15262 > 0f))) * _e15236);
let _e15270 = (_e15247 - _e15250);
let _e15271 = -(_e15270);
let _e15274 = (_e15234 - select(_e15271, _e15270, (_e15270 > _e15271)));
let _e15276 = select(0f, _e15274, (_e15274 > 0f));
let _e15278 = select(_e15232, _e15276, (_e15276 < _e15232));
let _e15281 = (_e15274 - _e15232);
let _e15285 = (((_e15278 * (_e15278 * _e15235)) + select(0f, _e15281, (_e15281 > 0f))) * _e15236);
if _e452 {
phi_37585_ = type_23(_e15240, _e15148);
} else {
phi_37585_ = type_23(_e15148, _e15240);
}
let _e15294 = phi_37585_;
local_76 = bitcast<i32>((_e14375 * _e14378));
local_77 = ((_e15294.member_1 * _e14379) + _e15294.member);
let _e15301 = local_76;
let _e15302 = local_77;
let _e15303 = (_e15301 + _e15302);
let _e15305 = (bitcast<i32>(_e258) - 1i);
let _e15307 = select(_e15305, _e15303, (_e15303 < _e15305));
let _e15312 = global_5.member[bitcast<u32>(select(0i, _e15307, (_e15307 > 0i)))];
let _e15313 = local_77;
let _e15315 = select(_e15305, _e15313, (_e15313 < _e15305));
let _e15320 = global_5.member[bitcast<u32>(select(0i, _e15315, (_e15315 > 0i)))];
let _e15323 = f32(_e14379);
let _e15324 = f32(_e14380);
let _e15331 = global_1.member.member_2.member;
let _e15332 = (((((f32(_e15294.member) + 0.5f) / _e15323) * 2f) - 1f) * _e15331);
let _e15339 = global_1.member.member_2.member_1;
let _e15340 = ((1f - (((f32(_e15294.member_1) + 0.5f) / _e15324) * 2f)) * _e15339);
let _e15342 = global_1.member.member_3;
let _e15350 = global_1.member.member_4;
let _e15357 = ((_e15342.member * _e15332) + (_e15350.member * _e15340));
let _e15358 = ((_e15342.member_1 * _e15332) + (_e15350.member_1 * _e15340));
let _e15359 = ((_e15342.member_2 * _e15332) + (_e15350.member_2 * _e15340));
let _e15362 = global_1.member.member_2.member_3;
let _e15363 = (_e15362 != 0u);
let _e15365 = global_1.member.member_5;
let _e15372 = select((_e15365.member + _e15357), _e15365.member, _e15363);
let _e15373 = select((_e15365.member_1 + _e15358), _e15365.member_1, _e15363);
let _e15374 = select((_e15365.member_2 + _e15359), _e15365.member_2, _e15363);
let _e15376 = global_1.member.member_6;
let _e15390 = (((_e15372 * _e15372) + (_e15373 * _e15373)) + (_e15374 * _e15374));
let _e15393 = sqrt(select(0f, _e15390, (_e15390 > 0f)));
let _e15394 = (1f / _e15393);
let _e15395 = (_e15372 * _e15394);
let _e15396 = (_e15373 * _e15394);
let _e15397 = (_e15374 * _e15394);
let _e15398 = (_e574 - select(_e15376.member, (_e15376.member + _e15357), _e15363));
let _e15399 = (_e586 - select(_e15376.member_1, (_e15376.member_1 + _e15358), _e15363));
let _e15400 = (_e599 - select(_e15376.member_2, (_e15376.member_2 + _e15359), _e15363));
let _e15405 = (((_e15398 * _e15395) + (_e15399 * _e15396)) + (_e15400 * _e15397));
let _e15410 = (((_e15398 * _e612) + (_e15399 * _e625)) + (_e15400 * _e638));
let _e15415 = (((_e15395 * _e612) + (_e15396 * _e625)) + (_e15397 * _e638));
let _e15418 = ((_e15396 * _e638) - (_e15397 * _e625));
let _e15421 = ((_e15397 * _e612) - (_e15395 * _e638));
let _e15424 = ((_e15395 * _e625) - (_e15396 * _e612));
let _e15429 = (((_e15418 * _e15418) + (_e15421 * _e15421)) + (_e15424 * _e15424));
let _e15432 = (1f / select(1e-9f, _e15429, (_e15429 > 1e-9f)));
let _e15435 = ((_e15405 - (_e15415 * _e15410)) * _e15432);
let _e15438 = (((_e15415 * _e15405) - _e15410) * _e15432);
let _e15444 = -(_e15415);
let _e15447 = global_1.member.member_13.member_2;
let _e15448 = (_e15447 * _e15447);
let _e15452 = ((1f + _e15448) - ((2f * _e15447) * _e15444));
let _e15454 = select(1e-9f, _e15452, (_e15452 > 1e-9f));
let _e15466 = global_1.member.member_13.member_3;
let _e15471 = (_e15393 * (select(((1f - _e15448) / (_e15454 * sqrt(select(0f, _e15454, (_e15454 > 0f))))), (0.75f * (1f + (_e15444 * _e15444))), (_e15466 == 1u)) * (0.25f / 3.1415927f)));
let _e15472 = (_e15435 - _e15312);
let _e15475 = (_e15438 + select(0f, _e15472, (_e15472 > 0f)));
let _e15478 = global_1.member.member_13.member_1;
let _e15487 = global_1.member.member_13.member;
let _e15492 = -((_e15487.member * _e15475));
let _e15494 = select(-87f, _e15492, (_e15492 > -87f));
let _e15496 = select(88f, _e15494, (_e15494 < 88f));
let _e15498 = ((_e15496 * 1.442695f) + 0.5f);
let _e15500 = select(-127f, _e15498, (_e15498 > -127f));
let _e15502 = select(128f, _e15500, (_e15500 < 128f));
let _e15509 = select(0i, select(select(i32(_e15502), i32(-2147483648), (_e15502 < -2147483600f)), 2147483647i, (_e15502 > 2147483500f)), (_e15502 == _e15502));
let _e15513 = (_e15509 - select(0i, 1i, (_e15502 < f32(_e15509))));
let _e15514 = f32(_e15513);
let _e15518 = ((_e15496 - (_e15514 * 0.6933594f)) - (_e15514 * -2.1219444e-4f));
let _e15540 = -((_e15487.member_1 * _e15475));
let _e15542 = select(-87f, _e15540, (_e15540 > -87f));
let _e15544 = select(88f, _e15542, (_e15542 < 88f));
let _e15546 = ((_e15544 * 1.442695f) + 0.5f);
let _e15548 = select(-127f, _e15546, (_e15546 > -127f));
let _e15550 = select(128f, _e15548, (_e15548 < 128f));
let _e15557 = select(0i, select(select(i32(_e15550), i32(-2147483648), (_e15550 < -2147483600f)), 2147483647i, (_e15550 > 2147483500f)), (_e15550 == _e15550));
let _e15561 = (_e15557 - select(0i, 1i, (_e15550 < f32(_e15557))));
let _e15562 = f32(_e15561);
let _e15566 = ((_e15544 - (_e15562 * 0.6933594f)) - (_e15562 * -2.1219444e-4f));
let _e15588 = -((_e15487.member_2 * _e15475));
let _e15590 = select(-87f, _e15588, (_e15588 > -87f));
let _e15592 = select(88f, _e15590, (_e15590 < 88f));
let _e15594 = ((_e15592 * 1.442695f) + 0.5f);
let _e15596 = select(-127f, _e15594, (_e15594 > -127f));
let _e15598 = select(128f, _e15596, (_e15596 < 128f));
let _e15605 = select(0i, select(select(i32(_e15598), i32(-2147483648), (_e15598 < -2147483600f)), 2147483647i, (_e15598 > 2147483500f)), (_e15598 == _e15598));
let _e15609 = (_e15605 - select(0i, 1i, (_e15598 < f32(_e15605))));
let _e15610 = f32(_e15609);
let _e15614 = ((_e15592 - (_e15610 * 0.6933594f)) - (_e15610 * -2.1219444e-4f));
let _e15641 = select(0f, _e15435, (((_e15438 >= 0f) && (_e15438 < _e690)) && (_e15435 > 0f)));
let _e15643 = ((_e765 + _e14432) + _e14436);
let _e15644 = (_e15643 & 31u);
let _e15646 = (1u << bitcast<u32>(_e15644));
let _e15655 = bitcast<i32>((((_e14375 + _e15646) - 1u) >> bitcast<u32>(_e15644)));
let _e15656 = bitcast<i32>((((_e14378 + _e15646) - 1u) >> bitcast<u32>(_e15644)));
if _e452 {
phi_38163_ = type_23(_e15656, _e15655);
} else {
phi_38163_ = type_23(_e15655, _e15656);
}
let _e15660 = phi_38163_;
let _e15665 = f32((1i << bitcast<u32>(_e15644)));
let _e15666 = (1f / _e15665);
let _e15668 = ((_e15150 * _e15666) - 0.5f);
let _e15670 = ((_e15243 * _e15666) - 0.5f);
let _e15672 = select(-1f, _e15668, (_e15668 > -1f));
let _e15674 = select(1e6f, _e15672, (_e15672 < 1e6f));
let _e15681 = select(0i, select(select(i32(_e15674), i32(-2147483648), (_e15674 < -2147483600f)), 2147483647i, (_e15674 > 2147483500f)), (_e15674 == _e15674));
let _e15685 = (_e15681 - select(0i, 1i, (_e15674 < f32(_e15681))));
let _e15687 = select(-1f, _e15670, (_e15670 > -1f));
let _e15689 = select(1e6f, _e15687, (_e15687 < 1e6f));
let _e15696 = select(0i, select(select(i32(_e15689), i32(-2147483648), (_e15689 < -2147483600f)), 2147483647i, (_e15689 > 2147483500f)), (_e15689 == _e15689));
let _e15700 = (_e15696 - select(0i, 1i, (_e15689 < f32(_e15696))));
let _e15702 = (_e15668 - f32(_e15685));
let _e15704 = (_e15670 - f32(_e15700));
let _e15705 = (1f - _e15702);
let _e15706 = (1f - _e15704);
let _e15709 = select(_e15685, 0i, (_e15685 < 0i));
let _e15710 = (_e15709 >= _e15660.member);
if _e15710 {
phi_38241_ = (_e15660.member - 1i);
} else {
phi_38241_ = _e15709;
}
let _e15713 = phi_38241_;
let _e15715 = select(_e15700, 0i, (_e15700 < 0i));
let _e15716 = (_e15715 >= _e15660.member_1);
if _e15716 {
phi_38252_ = (_e15660.member_1 - 1i);
} else {
phi_38252_ = _e15715;
}
let _e15719 = phi_38252_;
let _e15723 = (((f32(_e15713) + 0.5f) * _e15665) - 0.5f);
let _e15727 = (((f32(_e15719) + 0.5f) * _e15665) - 0.5f);
if _e452 {
phi_38280_ = type_23(_e15719, _e15713);
} else {
phi_38280_ = type_23(_e15713, _e15719);
}
let _e15733 = phi_38280_;
let _e15739 = bitcast<i32>(((_e14375 + 1u) >> bitcast<u32>(1u)));
let _e15742 = global_1.member.member_18.member_6;
let _e15745 = global_1.member.member_18.member_7;
let _e15748 = global_1.member.member_18.member_8;
let _e15749 = (_e15643 == 0u);
if _e15749 {
phi_38331_ = 0u;
} else {
if (_e15643 == 1u) {
phi_38330_ = 0u;
} else {
if (_e15643 == 2u) {
phi_38329_ = _e15742;
} else {
phi_38329_ = select(_e15748, _e15745, (_e15643 == 3u));
}
let _e15755 = phi_38329_;
phi_38330_ = _e15755;
}
let _e15757 = phi_38330_;
phi_38331_ = _e15757;
}
let _e15759 = phi_38331_;
local_74 = (((bitcast<i32>(_e15759) + _e15733.member_1) * _e15739) + _e15733.member);
let _e15764 = local_74;
let _e15766 = (bitcast<i32>(_e261) - 1i);
let _e15768 = select(_e15766, _e15764, (_e15764 < _e15766));
let _e15773 = global_6.member[bitcast<u32>(select(0i, _e15768, (_e15768 > 0i)))];
let _e15778 = (((((select(_e15723, _e15727, _e452) + 0.5f) / _e15323) * 2f) - 1f) * _e15331);
let _e15783 = ((1f - (((select(_e15727, _e15723, _e452) + 0.5f) / _e15324) * 2f)) * _e15339);
let _e15790 = ((_e15342.member * _e15778) + (_e15350.member * _e15783));
let _e15791 = ((_e15342.member_1 * _e15778) + (_e15350.member_1 * _e15783));
let _e15792 = ((_e15342.member_2 * _e15778) + (_e15350.member_2 * _e15783));
let _e15796 = select((_e15365.member + _e15790), _e15365.member, _e15363);
let _e15797 = select((_e15365.member_1 + _e15791), _e15365.member_1, _e15363);
let _e15798 = select((_e15365.member_2 + _e15792), _e15365.member_2, _e15363);
let _e15809 = (((_e15796 * _e15796) + (_e15797 * _e15797)) + (_e15798 * _e15798));
let _e15813 = (1f / sqrt(select(0f, _e15809, (_e15809 > 0f))));
let _e15814 = (_e15796 * _e15813);
let _e15815 = (_e15797 * _e15813);
let _e15816 = (_e15798 * _e15813);
let _e15817 = (_e574 - select(_e15376.member, (_e15376.member + _e15790), _e15363));
let _e15818 = (_e586 - select(_e15376.member_1, (_e15376.member_1 + _e15791), _e15363));
let _e15819 = (_e599 - select(_e15376.member_2, (_e15376.member_2 + _e15792), _e15363));
let _e15824 = (((_e15817 * _e15814) + (_e15818 * _e15815)) + (_e15819 * _e15816));
let _e15829 = (((_e15817 * _e612) + (_e15818 * _e625)) + (_e15819 * _e638));
let _e15834 = (((_e15814 * _e612) + (_e15815 * _e625)) + (_e15816 * _e638));
let _e15837 = ((_e15815 * _e638) - (_e15816 * _e625));
let _e15840 = ((_e15816 * _e612) - (_e15814 * _e638));
let _e15843 = ((_e15814 * _e625) - (_e15815 * _e612));
let _e15848 = (((_e15837 * _e15837) + (_e15840 * _e15840)) + (_e15843 * _e15843));
let _e15851 = (1f / select(1e-9f, _e15848, (_e15848 > 1e-9f)));
let _e15854 = ((_e15824 - (_e15834 * _e15829)) * _e15851);
let _e15857 = (((_e15834 * _e15824) - _e15829) * _e15851);
let _e15863 = select(0f, _e15854, (((_e15857 >= 0f) && (_e15857 < _e690)) && (_e15854 > 0f)));
let _e15865 = (_e15713 << bitcast<u32>(_e15644));
let _e15877 = (_e15685 + 1i);
let _e15880 = select(_e15877, 0i, (_e15877 < 0i));
let _e15881 = (_e15880 >= _e15660.member);
if _e15881 {
phi_38878_ = (_e15660.member - 1i);
} else {
phi_38878_ = _e15880;
}
let _e15884 = phi_38878_;
if _e15716 {
phi_38889_ = (_e15660.member_1 - 1i);
} else {
phi_38889_ = _e15715;
}
let _e15887 = phi_38889_;
let _e15891 = (((f32(_e15884) + 0.5f) * _e15665) - 0.5f);
let _e15895 = (((f32(_e15887) + 0.5f) * _e15665) - 0.5f);
if _e452 {
phi_38917_ = type_23(_e15887, _e15884);
} else {
phi_38917_ = type_23(_e15884, _e15887);
}
let _e15901 = phi_38917_;
if _e15749 {
phi_38968_ = 0u;
} else {
if (_e15643 == 1u) {
phi_38967_ = 0u;
} else {
if (_e15643 == 2u) {
phi_38966_ = _e15742;
} else {
phi_38966_ = select(_e15748, _e15745, (_e15643 == 3u));
}
let _e15909 = phi_38966_;
phi_38967_ = _e15909;
}
let _e15911 = phi_38967_;
phi_38968_ = _e15911;
}
let _e15913 = phi_38968_;
local_72 = (((bitcast<i32>(_e15913) + _e15901.member_1) * _e15739) + _e15901.member);
let _e15918 = local_72;
let _e15920 = select(_e15766, _e15918, (_e15918 < _e15766));
let _e15925 = global_6.member[bitcast<u32>(select(0i, _e15920, (_e15920 > 0i)))];
let _e15930 = (((((select(_e15891, _e15895, _e452) + 0.5f) / _e15323) * 2f) - 1f) * _e15331);
let _e15935 = ((1f - (((select(_e15895, _e15891, _e452) + 0.5f) / _e15324) * 2f)) * _e15339);
let _e15942 = ((_e15342.member * _e15930) + (_e15350.member * _e15935));
let _e15943 = ((_e15342.member_1 * _e15930) + (_e15350.member_1 * _e15935));
let _e15944 = ((_e15342.member_2 * _e15930) + (_e15350.member_2 * _e15935));
let _e15948 = select((_e15365.member + _e15942), _e15365.member, _e15363);
let _e15949 = select((_e15365.member_1 + _e15943), _e15365.member_1, _e15363);
let _e15950 = select((_e15365.member_2 + _e15944), _e15365.member_2, _e15363);
let _e15961 = (((_e15948 * _e15948) + (_e15949 * _e15949)) + (_e15950 * _e15950));
let _e15965 = (1f / sqrt(select(0f, _e15961, (_e15961 > 0f))));
let _e15966 = (_e15948 * _e15965);
let _e15967 = (_e15949 * _e15965);
let _e15968 = (_e15950 * _e15965);
let _e15969 = (_e574 - select(_e15376.member, (_e15376.member + _e15942), _e15363));
let _e15970 = (_e586 - select(_e15376.member_1, (_e15376.member_1 + _e15943), _e15363));
let _e15971 = (_e599 - select(_e15376.member_2, (_e15376.member_2 + _e15944), _e15363));
let _e15976 = (((_e15969 * _e15966) + (_e15970 * _e15967)) + (_e15971 * _e15968));
let _e15981 = (((_e15969 * _e612) + (_e15970 * _e625)) + (_e15971 * _e638));
let _e15986 = (((_e15966 * _e612) + (_e15967 * _e625)) + (_e15968 * _e638));
let _e15989 = ((_e15967 * _e638) - (_e15968 * _e625));
let _e15992 = ((_e15968 * _e612) - (_e15966 * _e638));
let _e15995 = ((_e15966 * _e625) - (_e15967 * _e612));
let _e16000 = (((_e15989 * _e15989) + (_e15992 * _e15992)) + (_e15995 * _e15995));
let _e16003 = (1f / select(1e-9f, _e16000, (_e16000 > 1e-9f)));
let _e16006 = ((_e15976 - (_e15986 * _e15981)) * _e16003);
let _e16009 = (((_e15986 * _e15976) - _e15981) * _e16003);
let _e16015 = select(0f, _e16006, (((_e16009 >= 0f) && (_e16009 < _e690)) && (_e16006 > 0f)));
let _e16017 = (_e15884 << bitcast<u32>(_e15644));
let _e16029 = (_e15700 + 1i);
if _e15710 {
phi_39515_ = (_e15660.member - 1i);
} else {
phi_39515_ = _e15709;
}
let _e16033 = phi_39515_;
let _e16035 = select(_e16029, 0i, (_e16029 < 0i));
let _e16036 = (_e16035 >= _e15660.member_1);
if _e16036 {
phi_39526_ = (_e15660.member_1 - 1i);
} else {
phi_39526_ = _e16035;
}
let _e16039 = phi_39526_;
let _e16043 = (((f32(_e16033) + 0.5f) * _e15665) - 0.5f);
let _e16047 = (((f32(_e16039) + 0.5f) * _e15665) - 0.5f);
if _e452 {
phi_39554_ = type_23(_e16039, _e16033);
} else {
phi_39554_ = type_23(_e16033, _e16039);
}
let _e16053 = phi_39554_;
if _e15749 {
phi_39605_ = 0u;
} else {
if (_e15643 == 1u) {
phi_39604_ = 0u;
} else {
if (_e15643 == 2u) {
phi_39603_ = _e15742;
} else {
phi_39603_ = select(_e15748, _e15745, (_e15643 == 3u));
}
let _e16061 = phi_39603_;
phi_39604_ = _e16061;
}
let _e16063 = phi_39604_;
phi_39605_ = _e16063;
}
let _e16065 = phi_39605_;
local_70 = (((bitcast<i32>(_e16065) + _e16053.member_1) * _e15739) + _e16053.member);
let _e16070 = local_70;
let _e16072 = select(_e15766, _e16070, (_e16070 < _e15766));
let _e16077 = global_6.member[bitcast<u32>(select(0i, _e16072, (_e16072 > 0i)))];
let _e16082 = (((((select(_e16043, _e16047, _e452) + 0.5f) / _e15323) * 2f) - 1f) * _e15331);
let _e16087 = ((1f - (((select(_e16047, _e16043, _e452) + 0.5f) / _e15324) * 2f)) * _e15339);
let _e16094 = ((_e15342.member * _e16082) + (_e15350.member * _e16087));
let _e16095 = ((_e15342.member_1 * _e16082) + (_e15350.member_1 * _e16087));
let _e16096 = ((_e15342.member_2 * _e16082) + (_e15350.member_2 * _e16087));
let _e16100 = select((_e15365.member + _e16094), _e15365.member, _e15363);
let _e16101 = select((_e15365.member_1 + _e16095), _e15365.member_1, _e15363);
let _e16102 = select((_e15365.member_2 + _e16096), _e15365.member_2, _e15363);
let _e16113 = (((_e16100 * _e16100) + (_e16101 * _e16101)) + (_e16102 * _e16102));
let _e16117 = (1f / sqrt(select(0f, _e16113, (_e16113 > 0f))));
let _e16118 = (_e16100 * _e16117);
let _e16119 = (_e16101 * _e16117);
let _e16120 = (_e16102 * _e16117);
let _e16121 = (_e574 - select(_e15376.member, (_e15376.member + _e16094), _e15363));
let _e16122 = (_e586 - select(_e15376.member_1, (_e15376.member_1 + _e16095), _e15363));
let _e16123 = (_e599 - select(_e15376.member_2, (_e15376.member_2 + _e16096), _e15363));
let _e16128 = (((_e16121 * _e16118) + (_e16122 * _e16119)) + (_e16123 * _e16120));
let _e16133 = (((_e16121 * _e612) + (_e16122 * _e625)) + (_e16123 * _e638));
let _e16138 = (((_e16118 * _e612) + (_e16119 * _e625)) + (_e16120 * _e638));
let _e16141 = ((_e16119 * _e638) - (_e16120 * _e625));
let _e16144 = ((_e16120 * _e612) - (_e16118 * _e638));
let _e16147 = ((_e16118 * _e625) - (_e16119 * _e612));
let _e16152 = (((_e16141 * _e16141) + (_e16144 * _e16144)) + (_e16147 * _e16147));
let _e16155 = (1f / select(1e-9f, _e16152, (_e16152 > 1e-9f)));
let _e16158 = ((_e16128 - (_e16138 * _e16133)) * _e16155);
let _e16161 = (((_e16138 * _e16128) - _e16133) * _e16155);
let _e16167 = select(0f, _e16158, (((_e16161 >= 0f) && (_e16161 < _e690)) && (_e16158 > 0f)));
let _e16169 = (_e16033 << bitcast<u32>(_e15644));
if _e15881 {
phi_40152_ = (_e15660.member - 1i);
} else {
phi_40152_ = _e15880;
}
let _e16184 = phi_40152_;
if _e16036 {
phi_40163_ = (_e15660.member_1 - 1i);
} else {
phi_40163_ = _e16035;
}
let _e16187 = phi_40163_;
let _e16191 = (((f32(_e16184) + 0.5f) * _e15665) - 0.5f);
let _e16195 = (((f32(_e16187) + 0.5f) * _e15665) - 0.5f);
if _e452 {
phi_40191_ = type_23(_e16187, _e16184);
} else {
phi_40191_ = type_23(_e16184, _e16187);
}
let _e16201 = phi_40191_;
if _e15749 {
phi_40242_ = 0u;
} else {
if (_e15643 == 1u) {
phi_40241_ = 0u;
} else {
if (_e15643 == 2u) {
phi_40240_ = _e15742;
} else {
phi_40240_ = select(_e15748, _e15745, (_e15643 == 3u));
}
let _e16209 = phi_40240_;
phi_40241_ = _e16209;
}
let _e16211 = phi_40241_;
phi_40242_ = _e16211;
}
let _e16213 = phi_40242_;
local_68 = (((bitcast<i32>(_e16213) + _e16201.member_1) * _e15739) + _e16201.member);
let _e16218 = local_68;
let _e16220 = select(_e15766, _e16218, (_e16218 < _e15766));
let _e16225 = global_6.member[bitcast<u32>(select(0i, _e16220, (_e16220 > 0i)))];
let _e16230 = (((((select(_e16191, _e16195, _e452) + 0.5f) / _e15323) * 2f) - 1f) * _e15331);
let _e16235 = ((1f - (((select(_e16195, _e16191, _e452) + 0.5f) / _e15324) * 2f)) * _e15339);
let _e16242 = ((_e15342.member * _e16230) + (_e15350.member * _e16235));
let _e16243 = ((_e15342.member_1 * _e16230) + (_e15350.member_1 * _e16235));
let _e16244 = ((_e15342.member_2 * _e16230) + (_e15350.member_2 * _e16235));
let _e16248 = select((_e15365.member + _e16242), _e15365.member, _e15363);
let _e16249 = select((_e15365.member_1 + _e16243), _e15365.member_1, _e15363);
let _e16250 = select((_e15365.member_2 + _e16244), _e15365.member_2, _e15363);
let _e16261 = (((_e16248 * _e16248) + (_e16249 * _e16249)) + (_e16250 * _e16250));
let _e16265 = (1f / sqrt(select(0f, _e16261, (_e16261 > 0f))));
let _e16266 = (_e16248 * _e16265);
let _e16267 = (_e16249 * _e16265);
let _e16268 = (_e16250 * _e16265);
let _e16269 = (_e574 - select(_e15376.member, (_e15376.member + _e16242), _e15363));
let _e16270 = (_e586 - select(_e15376.member_1, (_e15376.member_1 + _e16243), _e15363));
let _e16271 = (_e599 - select(_e15376.member_2, (_e15376.member_2 + _e16244), _e15363));
let _e16276 = (((_e16269 * _e16266) + (_e16270 * _e16267)) + (_e16271 * _e16268));
let _e16281 = (((_e16269 * _e612) + (_e16270 * _e625)) + (_e16271 * _e638));
let _e16286 = (((_e16266 * _e612) + (_e16267 * _e625)) + (_e16268 * _e638));
let _e16289 = ((_e16267 * _e638) - (_e16268 * _e625));
let _e16292 = ((_e16268 * _e612) - (_e16266 * _e638));
let _e16295 = ((_e16266 * _e625) - (_e16267 * _e612));
let _e16300 = (((_e16289 * _e16289) + (_e16292 * _e16292)) + (_e16295 * _e16295));
let _e16303 = (1f / select(1e-9f, _e16300, (_e16300 > 1e-9f)));
let _e16306 = ((_e16276 - (_e16286 * _e16281)) * _e16303);
let _e16309 = (((_e16286 * _e16276) - _e16281) * _e16303);
let _e16315 = select(0f, _e16306, (((_e16309 >= 0f) && (_e16309 < _e690)) && (_e16306 > 0f)));
let _e16317 = (_e16184 << bitcast<u32>(_e15644));
let _e16329 = select(((((1f - select(0f, (_e15705 * _e15706), (((select(select(_e765, _e926, (_e15865 >= _e691)), _e846, (_e15865 < _e297)) == _e15643) && (_e15863 > 0f)) && (_e15863 < _e15773)))) - select(0f, (_e15702 * _e15706), (((select(select(_e765, _e926, (_e16017 >= _e691)), _e846, (_e16017 < _e297)) == _e15643) && (_e16015 > 0f)) && (_e16015 < _e15925)))) - select(0f, (_e15705 * _e15704), (((select(select(_e765, _e926, (_e16169 >= _e691)), _e846, (_e16169 < _e297)) == _e15643) && (_e16167 > 0f)) && (_e16167 < _e16077)))) - select(0f, (_e15702 * _e15704), (((select(select(_e765, _e926, (_e16317 >= _e691)), _e846, (_e16317 < _e297)) == _e15643) && (_e16315 > 0f)) && (_e16315 < _e16225)))), 1f, _e15749);
if _e452 {
phi_40798_ = type_23(_e15240, _e15148);
} else {
phi_40798_ = type_23(_e15148, _e15240);
}
let _e16344 = phi_40798_;
let _e16347 = (_e15241 && (((_e15641 > 0f) && (_e15641 < _e15320)) && (bitcast<f32>((bitcast<u32>(_e16329) & 2147483647u)) > 1e-6f)));
let _e16350 = global_1.member.member_18.member;
let _e16351 = (((select(_e15266, (1f - _e15266), (_e15251 >= 0f)) - select(_e15285, (1f - _e15285), (_e15270 >= 0f))) * (1f / _e15248)) * _e16350);
let _e16355 = select(0f, (((((_e651 * _e15478.member) * ((1f + (_e15518 * (1f + (_e15518 * (0.5f + (_e15518 * (0.16666667f + (_e15518 * (0.041666668f + (_e15518 * (0.008333334f + (_e15518 * (0.001388889f + (_e15518 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15513 + 127i)) << bitcast<u32>(23i))))) * _e15471) * _e16329) * _e16351), _e16347);
let _e16356 = select(0f, (((((_e664 * _e15478.member_1) * ((1f + (_e15566 * (1f + (_e15566 * (0.5f + (_e15566 * (0.16666667f + (_e15566 * (0.041666668f + (_e15566 * (0.008333334f + (_e15566 * (0.001388889f + (_e15566 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15561 + 127i)) << bitcast<u32>(23i))))) * _e15471) * _e16329) * _e16351), _e16347);
let _e16357 = select(0f, (((((_e677 * _e15478.member_2) * ((1f + (_e15614 * (1f + (_e15614 * (0.5f + (_e15614 * (0.16666667f + (_e15614 * (0.041666668f + (_e15614 * (0.008333334f + (_e15614 * (0.001388889f + (_e15614 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e15609 + 127i)) << bitcast<u32>(23i))))) * _e15471) * _e16329) * _e16351), _e16347);
let _e16361 = (bitcast<f32>((bitcast<u32>(_e16355) & 2147483647u)) >= 1073741800f);
let _e16362 = (1f / 1048576f);
let _e16365 = ((_e16355 * select(1f, _e16362, _e16361)) + 0.5f);
let _e16367 = select(-1073741800f, _e16365, (_e16365 > -1073741800f));
let _e16369 = select(1073741800f, _e16367, (_e16367 < 1073741800f));
let _e16376 = select(0i, select(select(i32(_e16369), i32(-2147483648), (_e16369 < -2147483600f)), 2147483647i, (_e16369 > 2147483500f)), (_e16369 == _e16369));
let _e16380 = (_e16376 - select(0i, 1i, (_e16369 < f32(_e16376))));
let _e16381 = select(0i, 20i, _e16361);
let _e16385 = (bitcast<u32>(_e16380) << bitcast<u32>((_e16381 & 31i)));
let _e16392 = bitcast<u32>(((_e16380 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16381) & 31i))));
let _e16396 = (bitcast<f32>((bitcast<u32>(_e16356) & 2147483647u)) >= 1073741800f);
let _e16399 = ((_e16356 * select(1f, _e16362, _e16396)) + 0.5f);
let _e16401 = select(-1073741800f, _e16399, (_e16399 > -1073741800f));
let _e16403 = select(1073741800f, _e16401, (_e16401 < 1073741800f));
let _e16410 = select(0i, select(select(i32(_e16403), i32(-2147483648), (_e16403 < -2147483600f)), 2147483647i, (_e16403 > 2147483500f)), (_e16403 == _e16403));
let _e16414 = (_e16410 - select(0i, 1i, (_e16403 < f32(_e16410))));
let _e16415 = select(0i, 20i, _e16396);
let _e16419 = (bitcast<u32>(_e16414) << bitcast<u32>((_e16415 & 31i)));
let _e16426 = bitcast<u32>(((_e16414 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16415) & 31i))));
let _e16430 = (bitcast<f32>((bitcast<u32>(_e16357) & 2147483647u)) >= 1073741800f);
let _e16433 = ((_e16357 * select(1f, _e16362, _e16430)) + 0.5f);
let _e16435 = select(-1073741800f, _e16433, (_e16433 > -1073741800f));
let _e16437 = select(1073741800f, _e16435, (_e16435 < 1073741800f));
let _e16444 = select(0i, select(select(i32(_e16437), i32(-2147483648), (_e16437 < -2147483600f)), 2147483647i, (_e16437 > 2147483500f)), (_e16437 == _e16437));
let _e16448 = (_e16444 - select(0i, 1i, (_e16437 < f32(_e16444))));
let _e16449 = select(0i, 20i, _e16430);
let _e16453 = (bitcast<u32>(_e16448) << bitcast<u32>((_e16449 & 31i)));
let _e16460 = bitcast<u32>(((_e16448 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e16449) & 31i))));
let _e16465 = bitcast<i32>(bitcast<u32>((((_e16344.member_1 * _e14379) + _e16344.member) * 6i)));
if ((_e16385 | _e16392) == 0u) {
} else {
let _e16468 = bitcast<u32>(_e16465);
if (_e16468 < _e269) {
let _e16472 = atomicAdd((&global_8.member[_e16468]), _e16385);
phi_41031_ = _e16472;
} else {
phi_41031_ = 0u;
}
let _e16474 = phi_41031_;
let _e16478 = (_e16392 + select(0u, 1u, ((_e16474 + _e16385) < _e16385)));
if (_e16478 == 0u) {
} else {
let _e16480 = (_e16468 + 1u);
if (_e16480 < _e269) {
let _e16484 = atomicAdd((&global_8.member[_e16480]), _e16478);
}
}
}
if ((_e16419 | _e16426) == 0u) {
} else {
let _e16488 = bitcast<u32>((_e16465 + 2i));
if (_e16488 < _e269) {
let _e16492 = atomicAdd((&global_8.member[_e16488]), _e16419);
phi_41061_ = _e16492;
} else {
phi_41061_ = 0u;
}
let _e16494 = phi_41061_;
let _e16498 = (_e16426 + select(0u, 1u, ((_e16494 + _e16419) < _e16419)));
if (_e16498 == 0u) {
} else {
let _e16500 = (_e16488 + 1u);
if (_e16500 < _e269) {
let _e16504 = atomicAdd((&global_8.member[_e16500]), _e16498);
}
}
}
if ((_e16453 | _e16460) == 0u) {
} else {
let _e16508 = bitcast<u32>((_e16465 + 4i));
if (_e16508 < _e269) {
let _e16512 = atomicAdd((&global_8.member[_e16508]), _e16453);
phi_41091_ = _e16512;
} else {
phi_41091_ = 0u;
}
let _e16514 = phi_41091_;
let _e16518 = (_e16460 + select(0u, 1u, ((_e16514 + _e16453) < _e16453)));
if (_e16518 == 0u) {
} else {
let _e16520 = (_e16508 + 1u);
if (_e16520 < _e269) {
let _e16524 = atomicAdd((&global_8.member[_e16520]), _e16518);
}
}
}
phi_37481_ = (_e15238 + 1i);
} else {
phi_37481_ = i32();
}
let _e16527 = phi_37481_;
continue;
continuing {
phi_37480_ = _e16527;
break if !(_e15241);
}
}
phi_37327_ = (_e15145 + 1i);
} else {
phi_37327_ = i32();
}
let _e16531 = phi_37327_;
continue;
continuing {
phi_37326_ = _e16531;
break if !(_e15146);
}
}
} else {
phi_41136_ = 0i;
loop {
let _e16534 = phi_41136_;
let _e16535 = (_e16534 < 16i);
if _e16535 {
let _e16537 = (_e14424 + (_e16534 & 15i));
let _e16539 = (f32(_e16537) + 0.5f);
let _e16541 = ((_e16539 * 1f) - 0.5f);
let _e16545 = (-(((_e415 * _e16541) + _e441)) / _e428);
let _e16552 = bitcast<f32>((bitcast<u32>(((_e465 * _e16541) + ((_e478 * _e16545) + _e491))) & 2147483647u));
let _e16559 = bitcast<f32>((bitcast<u32>(((_e504 * _e16541) + ((_e517 * _e16545) + _e530))) & 2147483647u));
let _e16563 = (((0.5f * (_e16552 + _e16559)) / _e533) + _e716);
let _e16564 = (1f / 1f);
let _e16572 = ((((_e16545 + _e16563) + 0.5f) * _e16564) - 0.5f);
let _e16573 = f32(_e14429);
let _e16574 = (0f - 1f);
let _e16576 = select(_e16574, _e16572, (_e16572 > _e16574));
let _e16578 = select(_e16573, _e16576, (_e16576 < _e16573));
let _e16585 = select(0i, select(select(i32(_e16578), i32(-2147483648), (_e16578 < -2147483600f)), 2147483647i, (_e16578 > 2147483500f)), (_e16578 == _e16578));
let _e16590 = (((((_e16545 - _e16563) + 0.5f) * _e16564) - 0.5f) + 1f);
let _e16591 = (_e16573 + 1f);
let _e16593 = select(0f, _e16590, (_e16590 > 0f));
let _e16595 = select(_e16591, _e16593, (_e16593 < _e16591));
let _e16602 = select(0i, select(select(i32(_e16595), i32(-2147483648), (_e16595 < -2147483600f)), 2147483647i, (_e16595 > 2147483500f)), (_e16595 == _e16595));
let _e16613 = ((1e-4f * 1f) * _e533);
let _e16615 = select(_e16559, _e16552, (_e16552 > _e16559));
let _e16617 = select(_e16613, _e16615, (_e16615 > _e16613));
let _e16619 = select(_e16559, _e16552, (_e16552 < _e16559));
let _e16621 = select(_e16613, _e16619, (_e16619 > _e16613));
let _e16623 = (0.5f * (_e16617 + _e16621));
let _e16624 = (0.5f / _e16621);
let _e16625 = (1f / _e16617);
phi_41290_ = 0i;
loop {
let _e16627 = phi_41290_;
let _e16629 = (((_e16602 - select(0i, 1i, (_e16595 < f32(_e16602)))) + (_e16534 >> bitcast<u32>(4u))) + bitcast<i32>(_e16627));
let _e16630 = (_e16629 <= select(-1i, (_e16585 - select(0i, 1i, (_e16578 < f32(_e16585)))), (_e16537 <= _e14428)));
if _e16630 {
let _e16632 = (f32(_e16629) + 0.5f);
let _e16636 = ((((_e16632 * 1f) - 0.5f) - _e16545) * _e533);
let _e16637 = (_e533 * 1f);
let _e16639 = (0.5f * _e16637);
let _e16640 = (_e16636 + _e16639);
let _e16641 = -(_e16640);
let _e16644 = (_e16623 - select(_e16641, _e16640, (_e16640 > _e16641)));
let _e16646 = select(0f, _e16644, (_e16644 > 0f));
let _e16648 = select(_e16621, _e16646, (_e16646 < _e16621));
let _e16651 = (_e16644 - _e16621);
let _e16655 = (((_e16648 * (_e16648 * _e16624)) + select(0f, _e16651, (_e16651 > 0f))) * _e16625);
let _e16659 = (_e16636 - _e16639);
let _e16660 = -(_e16659);
let _e16663 = (_e16623 - select(_e16660, _e16659, (_e16659 > _e16660)));
let _e16665 = select(0f, _e16663, (_e16663 > 0f));
let _e16667 = select(_e16621, _e16665, (_e16665 < _e16621));
let _e16670 = (_e16663 - _e16621);
let _e16674 = (((_e16667 * (_e16667 * _e16624)) + select(0f, _e16670, (_e16670 > 0f))) * _e16625);
if _e452 {
phi_41395_ = type_23(_e16629, _e16537);
} else {
phi_41395_ = type_23(_e16537, _e16629);
}
let _e16683 = phi_41395_;
local_66 = bitcast<i32>((_e14375 * _e14378));
local_67 = ((_e16683.member_1 * _e14379) + _e16683.member);
let _e16690 = local_66;
let _e16691 = local_67;
let _e16692 = (_e16690 + _e16691);
let _e16694 = (bitcast<i32>(_e258) - 1i);
let _e16696 = select(_e16694, _e16692, (_e16692 < _e16694));
let _e16701 = global_5.member[bitcast<u32>(select(0i, _e16696, (_e16696 > 0i)))];
let _e16702 = local_67;
let _e16704 = select(_e16694, _e16702, (_e16702 < _e16694));
let _e16709 = global_5.member[bitcast<u32>(select(0i, _e16704, (_e16704 > 0i)))];
let _e16712 = f32(_e14379);
let _e16713 = f32(_e14380);
let _e16720 = global_1.member.member_2.member;
let _e16721 = (((((f32(_e16683.member) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e16728 = global_1.member.member_2.member_1;
let _e16729 = ((1f - (((f32(_e16683.member_1) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e16731 = global_1.member.member_3;
let _e16739 = global_1.member.member_4;
let _e16746 = ((_e16731.member * _e16721) + (_e16739.member * _e16729));
let _e16747 = ((_e16731.member_1 * _e16721) + (_e16739.member_1 * _e16729));
let _e16748 = ((_e16731.member_2 * _e16721) + (_e16739.member_2 * _e16729));
let _e16751 = global_1.member.member_2.member_3;
let _e16752 = (_e16751 != 0u);
let _e16754 = global_1.member.member_5;
let _e16761 = select((_e16754.member + _e16746), _e16754.member, _e16752);
let _e16762 = select((_e16754.member_1 + _e16747), _e16754.member_1, _e16752);
let _e16763 = select((_e16754.member_2 + _e16748), _e16754.member_2, _e16752);
let _e16765 = global_1.member.member_6;
let _e16779 = (((_e16761 * _e16761) + (_e16762 * _e16762)) + (_e16763 * _e16763));
let _e16782 = sqrt(select(0f, _e16779, (_e16779 > 0f)));
let _e16783 = (1f / _e16782);
let _e16784 = (_e16761 * _e16783);
let _e16785 = (_e16762 * _e16783);
let _e16786 = (_e16763 * _e16783);
let _e16787 = (_e574 - select(_e16765.member, (_e16765.member + _e16746), _e16752));
let _e16788 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e16747), _e16752));
let _e16789 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e16748), _e16752));
let _e16794 = (((_e16787 * _e16784) + (_e16788 * _e16785)) + (_e16789 * _e16786));
let _e16799 = (((_e16787 * _e612) + (_e16788 * _e625)) + (_e16789 * _e638));
let _e16804 = (((_e16784 * _e612) + (_e16785 * _e625)) + (_e16786 * _e638));
let _e16807 = ((_e16785 * _e638) - (_e16786 * _e625));
let _e16810 = ((_e16786 * _e612) - (_e16784 * _e638));
let _e16813 = ((_e16784 * _e625) - (_e16785 * _e612));
let _e16818 = (((_e16807 * _e16807) + (_e16810 * _e16810)) + (_e16813 * _e16813));
let _e16821 = (1f / select(1e-9f, _e16818, (_e16818 > 1e-9f)));
let _e16824 = ((_e16794 - (_e16804 * _e16799)) * _e16821);
let _e16827 = (((_e16804 * _e16794) - _e16799) * _e16821);
let _e16833 = -(_e16804);
let _e16836 = global_1.member.member_13.member_2;
let _e16837 = (_e16836 * _e16836);
let _e16841 = ((1f + _e16837) - ((2f * _e16836) * _e16833));
let _e16843 = select(1e-9f, _e16841, (_e16841 > 1e-9f));
let _e16855 = global_1.member.member_13.member_3;
let _e16860 = (_e16782 * (select(((1f - _e16837) / (_e16843 * sqrt(select(0f, _e16843, (_e16843 > 0f))))), (0.75f * (1f + (_e16833 * _e16833))), (_e16855 == 1u)) * (0.25f / 3.1415927f)));
let _e16861 = (_e16824 - _e16701);
let _e16864 = (_e16827 + select(0f, _e16861, (_e16861 > 0f)));
let _e16867 = global_1.member.member_13.member_1;
let _e16876 = global_1.member.member_13.member;
let _e16881 = -((_e16876.member * _e16864));
let _e16883 = select(-87f, _e16881, (_e16881 > -87f));
let _e16885 = select(88f, _e16883, (_e16883 < 88f));
let _e16887 = ((_e16885 * 1.442695f) + 0.5f);
let _e16889 = select(-127f, _e16887, (_e16887 > -127f));
let _e16891 = select(128f, _e16889, (_e16889 < 128f));
let _e16898 = select(0i, select(select(i32(_e16891), i32(-2147483648), (_e16891 < -2147483600f)), 2147483647i, (_e16891 > 2147483500f)), (_e16891 == _e16891));
let _e16902 = (_e16898 - select(0i, 1i, (_e16891 < f32(_e16898))));
let _e16903 = f32(_e16902);
let _e16907 = ((_e16885 - (_e16903 * 0.6933594f)) - (_e16903 * -2.1219444e-4f));
let _e16929 = -((_e16876.member_1 * _e16864));
let _e16931 = select(-87f, _e16929, (_e16929 > -87f));
let _e16933 = select(88f, _e16931, (_e16931 < 88f));
let _e16935 = ((_e16933 * 1.442695f) + 0.5f);
let _e16937 = select(-127f, _e16935, (_e16935 > -127f));
let _e16939 = select(128f, _e16937, (_e16937 < 128f));
let _e16946 = select(0i, select(select(i32(_e16939), i32(-2147483648), (_e16939 < -2147483600f)), 2147483647i, (_e16939 > 2147483500f)), (_e16939 == _e16939));
let _e16950 = (_e16946 - select(0i, 1i, (_e16939 < f32(_e16946))));
let _e16951 = f32(_e16950);
let _e16955 = ((_e16933 - (_e16951 * 0.6933594f)) - (_e16951 * -2.1219444e-4f));
let _e16977 = -((_e16876.member_2 * _e16864));
let _e16979 = select(-87f, _e16977, (_e16977 > -87f));
let _e16981 = select(88f, _e16979, (_e16979 < 88f));
let _e16983 = ((_e16981 * 1.442695f) + 0.5f);
let _e16985 = select(-127f, _e16983, (_e16983 > -127f));
let _e16987 = select(128f, _e16985, (_e16985 < 128f));
let _e16994 = select(0i, select(select(i32(_e16987), i32(-2147483648), (_e16987 < -2147483600f)), 2147483647i, (_e16987 > 2147483500f)), (_e16987 == _e16987));
let _e16998 = (_e16994 - select(0i, 1i, (_e16987 < f32(_e16994))));
let _e16999 = f32(_e16998);
let _e17003 = ((_e16981 - (_e16999 * 0.6933594f)) - (_e16999 * -2.1219444e-4f));
let _e17030 = select(0f, _e16824, (((_e16827 >= 0f) && (_e16827 < _e690)) && (_e16824 > 0f)));
let _e17031 = (_e765 & 31u);
let _e17033 = (1u << bitcast<u32>(_e17031));
let _e17042 = bitcast<i32>((((_e14375 + _e17033) - 1u) >> bitcast<u32>(_e17031)));
let _e17043 = bitcast<i32>((((_e14378 + _e17033) - 1u) >> bitcast<u32>(_e17031)));
if _e452 {
phi_41971_ = type_23(_e17043, _e17042);
} else {
phi_41971_ = type_23(_e17042, _e17043);
}
let _e17047 = phi_41971_;
let _e17052 = f32((1i << bitcast<u32>(_e17031)));
let _e17053 = (1f / _e17052);
let _e17055 = ((_e16539 * _e17053) - 0.5f);
let _e17057 = ((_e16632 * _e17053) - 0.5f);
let _e17059 = select(-1f, _e17055, (_e17055 > -1f));
let _e17061 = select(1e6f, _e17059, (_e17059 < 1e6f));
let _e17068 = select(0i, select(select(i32(_e17061), i32(-2147483648), (_e17061 < -2147483600f)), 2147483647i, (_e17061 > 2147483500f)), (_e17061 == _e17061));
let _e17072 = (_e17068 - select(0i, 1i, (_e17061 < f32(_e17068))));
let _e17074 = select(-1f, _e17057, (_e17057 > -1f));
let _e17076 = select(1e6f, _e17074, (_e17074 < 1e6f));
let _e17083 = select(0i, select(select(i32(_e17076), i32(-2147483648), (_e17076 < -2147483600f)), 2147483647i, (_e17076 > 2147483500f)), (_e17076 == _e17076));
let _e17087 = (_e17083 - select(0i, 1i, (_e17076 < f32(_e17083))));
let _e17089 = (_e17055 - f32(_e17072));
let _e17091 = (_e17057 - f32(_e17087));
let _e17092 = (1f - _e17089);
let _e17093 = (1f - _e17091);
let _e17096 = select(_e17072, 0i, (_e17072 < 0i));
let _e17097 = (_e17096 >= _e17047.member);
if _e17097 {
phi_42049_ = (_e17047.member - 1i);
} else {
phi_42049_ = _e17096;
}
let _e17100 = phi_42049_;
let _e17102 = select(_e17087, 0i, (_e17087 < 0i));
let _e17103 = (_e17102 >= _e17047.member_1);
if _e17103 {
phi_42060_ = (_e17047.member_1 - 1i);
} else {
phi_42060_ = _e17102;
}
let _e17106 = phi_42060_;
let _e17110 = (((f32(_e17100) + 0.5f) * _e17052) - 0.5f);
let _e17114 = (((f32(_e17106) + 0.5f) * _e17052) - 0.5f);
if _e452 {
phi_42088_ = type_23(_e17106, _e17100);
} else {
phi_42088_ = type_23(_e17100, _e17106);
}
let _e17120 = phi_42088_;
let _e17126 = bitcast<i32>(((_e14375 + 1u) >> bitcast<u32>(1u)));
let _e17129 = global_1.member.member_18.member_6;
let _e17132 = global_1.member.member_18.member_7;
let _e17135 = global_1.member.member_18.member_8;
if _e14430 {
phi_42139_ = 0u;
} else {
if (_e765 == 1u) {
phi_42138_ = 0u;
} else {
if (_e765 == 2u) {
phi_42137_ = _e17129;
} else {
phi_42137_ = select(_e17135, _e17132, (_e765 == 3u));
}
let _e17141 = phi_42137_;
phi_42138_ = _e17141;
}
let _e17143 = phi_42138_;
phi_42139_ = _e17143;
}
let _e17145 = phi_42139_;
local_64 = (((bitcast<i32>(_e17145) + _e17120.member_1) * _e17126) + _e17120.member);
let _e17150 = local_64;
let _e17152 = (bitcast<i32>(_e261) - 1i);
let _e17154 = select(_e17152, _e17150, (_e17150 < _e17152));
let _e17159 = global_6.member[bitcast<u32>(select(0i, _e17154, (_e17154 > 0i)))];
let _e17164 = (((((select(_e17110, _e17114, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17169 = ((1f - (((select(_e17114, _e17110, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17176 = ((_e16731.member * _e17164) + (_e16739.member * _e17169));
let _e17177 = ((_e16731.member_1 * _e17164) + (_e16739.member_1 * _e17169));
let _e17178 = ((_e16731.member_2 * _e17164) + (_e16739.member_2 * _e17169));
let _e17182 = select((_e16754.member + _e17176), _e16754.member, _e16752);
let _e17183 = select((_e16754.member_1 + _e17177), _e16754.member_1, _e16752);
let _e17184 = select((_e16754.member_2 + _e17178), _e16754.member_2, _e16752);
let _e17195 = (((_e17182 * _e17182) + (_e17183 * _e17183)) + (_e17184 * _e17184));
let _e17199 = (1f / sqrt(select(0f, _e17195, (_e17195 > 0f))));
let _e17200 = (_e17182 * _e17199);
let _e17201 = (_e17183 * _e17199);
let _e17202 = (_e17184 * _e17199);
let _e17203 = (_e574 - select(_e16765.member, (_e16765.member + _e17176), _e16752));
let _e17204 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e17177), _e16752));
let _e17205 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e17178), _e16752));
let _e17210 = (((_e17203 * _e17200) + (_e17204 * _e17201)) + (_e17205 * _e17202));
let _e17215 = (((_e17203 * _e612) + (_e17204 * _e625)) + (_e17205 * _e638));
let _e17220 = (((_e17200 * _e612) + (_e17201 * _e625)) + (_e17202 * _e638));
let _e17223 = ((_e17201 * _e638) - (_e17202 * _e625));
let _e17226 = ((_e17202 * _e612) - (_e17200 * _e638));
let _e17229 = ((_e17200 * _e625) - (_e17201 * _e612));
let _e17234 = (((_e17223 * _e17223) + (_e17226 * _e17226)) + (_e17229 * _e17229));
let _e17237 = (1f / select(1e-9f, _e17234, (_e17234 > 1e-9f)));
let _e17240 = ((_e17210 - (_e17220 * _e17215)) * _e17237);
let _e17243 = (((_e17220 * _e17210) - _e17215) * _e17237);
let _e17249 = select(0f, _e17240, (((_e17243 >= 0f) && (_e17243 < _e690)) && (_e17240 > 0f)));
let _e17251 = (_e17100 << bitcast<u32>(_e17031));
let _e17263 = (_e17072 + 1i);
let _e17266 = select(_e17263, 0i, (_e17263 < 0i));
let _e17267 = (_e17266 >= _e17047.member);
if _e17267 {
phi_42686_ = (_e17047.member - 1i);
} else {
phi_42686_ = _e17266;
}
let _e17270 = phi_42686_;
if _e17103 {
phi_42697_ = (_e17047.member_1 - 1i);
} else {
phi_42697_ = _e17102;
}
let _e17273 = phi_42697_;
let _e17277 = (((f32(_e17270) + 0.5f) * _e17052) - 0.5f);
let _e17281 = (((f32(_e17273) + 0.5f) * _e17052) - 0.5f);
if _e452 {
phi_42725_ = type_23(_e17273, _e17270);
} else {
phi_42725_ = type_23(_e17270, _e17273);
}
let _e17287 = phi_42725_;
if _e14430 {
phi_42776_ = 0u;
} else {
if (_e765 == 1u) {
phi_42775_ = 0u;
} else {
if (_e765 == 2u) {
phi_42774_ = _e17129;
} else {
phi_42774_ = select(_e17135, _e17132, (_e765 == 3u));
}
let _e17295 = phi_42774_;
phi_42775_ = _e17295;
}
let _e17297 = phi_42775_;
phi_42776_ = _e17297;
}
let _e17299 = phi_42776_;
local_62 = (((bitcast<i32>(_e17299) + _e17287.member_1) * _e17126) + _e17287.member);
let _e17304 = local_62;
let _e17306 = select(_e17152, _e17304, (_e17304 < _e17152));
let _e17311 = global_6.member[bitcast<u32>(select(0i, _e17306, (_e17306 > 0i)))];
let _e17316 = (((((select(_e17277, _e17281, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17321 = ((1f - (((select(_e17281, _e17277, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17328 = ((_e16731.member * _e17316) + (_e16739.member * _e17321));
let _e17329 = ((_e16731.member_1 * _e17316) + (_e16739.member_1 * _e17321));
let _e17330 = ((_e16731.member_2 * _e17316) + (_e16739.member_2 * _e17321));
let _e17334 = select((_e16754.member + _e17328), _e16754.member, _e16752);
let _e17335 = select((_e16754.member_1 + _e17329), _e16754.member_1, _e16752);
let _e17336 = select((_e16754.member_2 + _e17330), _e16754.member_2, _e16752);
let _e17347 = (((_e17334 * _e17334) + (_e17335 * _e17335)) + (_e17336 * _e17336));
let _e17351 = (1f / sqrt(select(0f, _e17347, (_e17347 > 0f))));
let _e17352 = (_e17334 * _e17351);
let _e17353 = (_e17335 * _e17351);
let _e17354 = (_e17336 * _e17351);
let _e17355 = (_e574 - select(_e16765.member, (_e16765.member + _e17328), _e16752));
let _e17356 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e17329), _e16752));
let _e17357 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e17330), _e16752));
let _e17362 = (((_e17355 * _e17352) + (_e17356 * _e17353)) + (_e17357 * _e17354));
let _e17367 = (((_e17355 * _e612) + (_e17356 * _e625)) + (_e17357 * _e638));
let _e17372 = (((_e17352 * _e612) + (_e17353 * _e625)) + (_e17354 * _e638));
let _e17375 = ((_e17353 * _e638) - (_e17354 * _e625));
let _e17378 = ((_e17354 * _e612) - (_e17352 * _e638));
let _e17381 = ((_e17352 * _e625) - (_e17353 * _e612));
let _e17386 = (((_e17375 * _e17375) + (_e17378 * _e17378)) + (_e17381 * _e17381));
let _e17389 = (1f / select(1e-9f, _e17386, (_e17386 > 1e-9f)));
let _e17392 = ((_e17362 - (_e17372 * _e17367)) * _e17389);
let _e17395 = (((_e17372 * _e17362) - _e17367) * _e17389);
let _e17401 = select(0f, _e17392, (((_e17395 >= 0f) && (_e17395 < _e690)) && (_e17392 > 0f)));
let _e17403 = (_e17270 << bitcast<u32>(_e17031));
let _e17415 = (_e17087 + 1i);
if _e17097 {
phi_43323_ = (_e17047.member - 1i);
} else {
phi_43323_ = _e17096;
}
let _e17419 = phi_43323_;
let _e17421 = select(_e17415, 0i, (_e17415 < 0i));
let _e17422 = (_e17421 >= _e17047.member_1);
if _e17422 {
phi_43334_ = (_e17047.member_1 - 1i);
} else {
phi_43334_ = _e17421;
}
let _e17425 = phi_43334_;
let _e17429 = (((f32(_e17419) + 0.5f) * _e17052) - 0.5f);
let _e17433 = (((f32(_e17425) + 0.5f) * _e17052) - 0.5f);
if _e452 {
phi_43362_ = type_23(_e17425, _e17419);
} else {
phi_43362_ = type_23(_e17419, _e17425);
}
let _e17439 = phi_43362_;
if _e14430 {
phi_43413_ = 0u;
} else {
if (_e765 == 1u) {
phi_43412_ = 0u;
} else {
if (_e765 == 2u) {
phi_43411_ = _e17129;
} else {
phi_43411_ = select(_e17135, _e17132, (_e765 == 3u));
}
let _e17447 = phi_43411_;
phi_43412_ = _e17447;
}
let _e17449 = phi_43412_;
phi_43413_ = _e17449;
}
let _e17451 = phi_43413_;
local_60 = (((bitcast<i32>(_e17451) + _e17439.member_1) * _e17126) + _e17439.member);
let _e17456 = local_60;
let _e17458 = select(_e17152, _e17456, (_e17456 < _e17152));
let _e17463 = global_6.member[bitcast<u32>(select(0i, _e17458, (_e17458 > 0i)))];
let _e17468 = (((((select(_e17429, _e17433, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17473 = ((1f - (((select(_e17433, _e17429, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17480 = ((_e16731.member * _e17468) + (_e16739.member * _e17473));
let _e17481 = ((_e16731.member_1 * _e17468) + (_e16739.member_1 * _e17473));
let _e17482 = ((_e16731.member_2 * _e17468) + (_e16739.member_2 * _e17473));
let _e17486 = select((_e16754.member + _e17480), _e16754.member, _e16752);
let _e17487 = select((_e16754.member_1 + _e17481), _e16754.member_1, _e16752);
let _e17488 = select((_e16754.member_2 + _e17482), _e16754.member_2, _e16752);
let _e17499 = (((_e17486 * _e17486) + (_e17487 * _e17487)) + (_e17488 * _e17488));
let _e17503 = (1f / sqrt(select(0f, _e17499, (_e17499 > 0f))));
let _e17504 = (_e17486 * _e17503);
let _e17505 = (_e17487 * _e17503);
let _e17506 = (_e17488 * _e17503);
let _e17507 = (_e574 - select(_e16765.member, (_e16765.member + _e17480), _e16752));
let _e17508 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e17481), _e16752));
let _e17509 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e17482), _e16752));
let _e17514 = (((_e17507 * _e17504) + (_e17508 * _e17505)) + (_e17509 * _e17506));
let _e17519 = (((_e17507 * _e612) + (_e17508 * _e625)) + (_e17509 * _e638));
let _e17524 = (((_e17504 * _e612) + (_e17505 * _e625)) + (_e17506 * _e638));
let _e17527 = ((_e17505 * _e638) - (_e17506 * _e625));
let _e17530 = ((_e17506 * _e612) - (_e17504 * _e638));
let _e17533 = ((_e17504 * _e625) - (_e17505 * _e612));
let _e17538 = (((_e17527 * _e17527) + (_e17530 * _e17530)) + (_e17533 * _e17533));
let _e17541 = (1f / select(1e-9f, _e17538, (_e17538 > 1e-9f)));
let _e17544 = ((_e17514 - (_e17524 * _e17519)) * _e17541);
let _e17547 = (((_e17524 * _e17514) - _e17519) * _e17541);
let _e17553 = select(0f, _e17544, (((_e17547 >= 0f) && (_e17547 < _e690)) && (_e17544 > 0f)));
let _e17555 = (_e17419 << bitcast<u32>(_e17031));
if _e17267 {
phi_43960_ = (_e17047.member - 1i);
} else {
phi_43960_ = _e17266;
}
let _e17570 = phi_43960_;
if _e17422 {
phi_43971_ = (_e17047.member_1 - 1i);
} else {
phi_43971_ = _e17421;
}
let _e17573 = phi_43971_;
let _e17577 = (((f32(_e17570) + 0.5f) * _e17052) - 0.5f);
let _e17581 = (((f32(_e17573) + 0.5f) * _e17052) - 0.5f);
if _e452 {
phi_43999_ = type_23(_e17573, _e17570);
} else {
phi_43999_ = type_23(_e17570, _e17573);
}
let _e17587 = phi_43999_;
if _e14430 {
phi_44050_ = 0u;
} else {
if (_e765 == 1u) {
phi_44049_ = 0u;
} else {
if (_e765 == 2u) {
phi_44048_ = _e17129;
} else {
phi_44048_ = select(_e17135, _e17132, (_e765 == 3u));
}
let _e17595 = phi_44048_;
phi_44049_ = _e17595;
}
let _e17597 = phi_44049_;
phi_44050_ = _e17597;
}
let _e17599 = phi_44050_;
local_58 = (((bitcast<i32>(_e17599) + _e17587.member_1) * _e17126) + _e17587.member);
let _e17604 = local_58;
let _e17606 = select(_e17152, _e17604, (_e17604 < _e17152));
let _e17611 = global_6.member[bitcast<u32>(select(0i, _e17606, (_e17606 > 0i)))];
let _e17616 = (((((select(_e17577, _e17581, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17621 = ((1f - (((select(_e17581, _e17577, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17628 = ((_e16731.member * _e17616) + (_e16739.member * _e17621));
let _e17629 = ((_e16731.member_1 * _e17616) + (_e16739.member_1 * _e17621));
let _e17630 = ((_e16731.member_2 * _e17616) + (_e16739.member_2 * _e17621));
let _e17634 = select((_e16754.member + _e17628), _e16754.member, _e16752);
let _e17635 = select((_e16754.member_1 + _e17629), _e16754.member_1, _e16752);
let _e17636 = select((_e16754.member_2 + _e17630), _e16754.member_2, _e16752);
let _e17647 = (((_e17634 * _e17634) + (_e17635 * _e17635)) + (_e17636 * _e17636));
let _e17651 = (1f / sqrt(select(0f, _e17647, (_e17647 > 0f))));
let _e17652 = (_e17634 * _e17651);
let _e17653 = (_e17635 * _e17651);
let _e17654 = (_e17636 * _e17651);
let _e17655 = (_e574 - select(_e16765.member, (_e16765.member + _e17628), _e16752));
let _e17656 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e17629), _e16752));
let _e17657 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e17630), _e16752));
let _e17662 = (((_e17655 * _e17652) + (_e17656 * _e17653)) + (_e17657 * _e17654));
let _e17667 = (((_e17655 * _e612) + (_e17656 * _e625)) + (_e17657 * _e638));
let _e17672 = (((_e17652 * _e612) + (_e17653 * _e625)) + (_e17654 * _e638));
let _e17675 = ((_e17653 * _e638) - (_e17654 * _e625));
let _e17678 = ((_e17654 * _e612) - (_e17652 * _e638));
let _e17681 = ((_e17652 * _e625) - (_e17653 * _e612));
let _e17686 = (((_e17675 * _e17675) + (_e17678 * _e17678)) + (_e17681 * _e17681));
let _e17689 = (1f / select(1e-9f, _e17686, (_e17686 > 1e-9f)));
let _e17692 = ((_e17662 - (_e17672 * _e17667)) * _e17689);
let _e17695 = (((_e17672 * _e17662) - _e17667) * _e17689);
let _e17701 = select(0f, _e17692, (((_e17695 >= 0f) && (_e17695 < _e690)) && (_e17692 > 0f)));
let _e17703 = (_e17570 << bitcast<u32>(_e17031));
let _e17715 = select(((((1f - select(0f, (_e17092 * _e17093), (((select(select(_e765, _e926, (_e17251 >= _e691)), _e846, (_e17251 < _e297)) == _e765) && (_e17249 > 0f)) && (_e17249 < _e17159)))) - select(0f, (_e17089 * _e17093), (((select(select(_e765, _e926, (_e17403 >= _e691)), _e846, (_e17403 < _e297)) == _e765) && (_e17401 > 0f)) && (_e17401 < _e17311)))) - select(0f, (_e17092 * _e17091), (((select(select(_e765, _e926, (_e17555 >= _e691)), _e846, (_e17555 < _e297)) == _e765) && (_e17553 > 0f)) && (_e17553 < _e17463)))) - select(0f, (_e17089 * _e17091), (((select(select(_e765, _e926, (_e17703 >= _e691)), _e846, (_e17703 < _e297)) == _e765) && (_e17701 > 0f)) && (_e17701 < _e17611)))), 1f, _e14430);
let _e17716 = (_e14432 & 31u);
let _e17718 = (1u << bitcast<u32>(_e17716));
let _e17727 = bitcast<i32>((((_e14375 + _e17718) - 1u) >> bitcast<u32>(_e17716)));
let _e17728 = bitcast<i32>((((_e14378 + _e17718) - 1u) >> bitcast<u32>(_e17716)));
if _e452 {
phi_44615_ = type_23(_e17728, _e17727);
} else {
phi_44615_ = type_23(_e17727, _e17728);
}
let _e17732 = phi_44615_;
let _e17737 = f32((1i << bitcast<u32>(_e17716)));
let _e17738 = (1f / _e17737);
let _e17740 = ((_e16539 * _e17738) - 0.5f);
let _e17742 = ((_e16632 * _e17738) - 0.5f);
let _e17744 = select(-1f, _e17740, (_e17740 > -1f));
let _e17746 = select(1e6f, _e17744, (_e17744 < 1e6f));
let _e17753 = select(0i, select(select(i32(_e17746), i32(-2147483648), (_e17746 < -2147483600f)), 2147483647i, (_e17746 > 2147483500f)), (_e17746 == _e17746));
let _e17757 = (_e17753 - select(0i, 1i, (_e17746 < f32(_e17753))));
let _e17759 = select(-1f, _e17742, (_e17742 > -1f));
let _e17761 = select(1e6f, _e17759, (_e17759 < 1e6f));
let _e17768 = select(0i, select(select(i32(_e17761), i32(-2147483648), (_e17761 < -2147483600f)), 2147483647i, (_e17761 > 2147483500f)), (_e17761 == _e17761));
let _e17772 = (_e17768 - select(0i, 1i, (_e17761 < f32(_e17768))));
let _e17774 = (_e17740 - f32(_e17757));
let _e17776 = (_e17742 - f32(_e17772));
let _e17777 = (1f - _e17774);
let _e17778 = (1f - _e17776);
let _e17781 = select(_e17757, 0i, (_e17757 < 0i));
let _e17782 = (_e17781 >= _e17732.member);
if _e17782 {
phi_44693_ = (_e17732.member - 1i);
} else {
phi_44693_ = _e17781;
}
let _e17785 = phi_44693_;
let _e17787 = select(_e17772, 0i, (_e17772 < 0i));
let _e17788 = (_e17787 >= _e17732.member_1);
if _e17788 {
phi_44704_ = (_e17732.member_1 - 1i);
} else {
phi_44704_ = _e17787;
}
let _e17791 = phi_44704_;
let _e17795 = (((f32(_e17785) + 0.5f) * _e17737) - 0.5f);
let _e17799 = (((f32(_e17791) + 0.5f) * _e17737) - 0.5f);
if _e452 {
phi_44732_ = type_23(_e17791, _e17785);
} else {
phi_44732_ = type_23(_e17785, _e17791);
}
let _e17805 = phi_44732_;
let _e17808 = (_e14432 == 0u);
if _e17808 {
phi_44783_ = 0u;
} else {
if (_e14432 == 1u) {
phi_44782_ = 0u;
} else {
if (_e14432 == 2u) {
phi_44781_ = _e17129;
} else {
phi_44781_ = select(_e17135, _e17132, (_e14432 == 3u));
}
let _e17814 = phi_44781_;
phi_44782_ = _e17814;
}
let _e17816 = phi_44782_;
phi_44783_ = _e17816;
}
let _e17818 = phi_44783_;
local_56 = (((bitcast<i32>(_e17818) + _e17805.member_1) * _e17126) + _e17805.member);
let _e17823 = local_56;
let _e17825 = select(_e17152, _e17823, (_e17823 < _e17152));
let _e17830 = global_6.member[bitcast<u32>(select(0i, _e17825, (_e17825 > 0i)))];
let _e17835 = (((((select(_e17795, _e17799, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17840 = ((1f - (((select(_e17799, _e17795, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17847 = ((_e16731.member * _e17835) + (_e16739.member * _e17840));
let _e17848 = ((_e16731.member_1 * _e17835) + (_e16739.member_1 * _e17840));
let _e17849 = ((_e16731.member_2 * _e17835) + (_e16739.member_2 * _e17840));
let _e17853 = select((_e16754.member + _e17847), _e16754.member, _e16752);
let _e17854 = select((_e16754.member_1 + _e17848), _e16754.member_1, _e16752);
let _e17855 = select((_e16754.member_2 + _e17849), _e16754.member_2, _e16752);
let _e17866 = (((_e17853 * _e17853) + (_e17854 * _e17854)) + (_e17855 * _e17855));
let _e17870 = (1f / sqrt(select(0f, _e17866, (_e17866 > 0f))));
let _e17871 = (_e17853 * _e17870);
let _e17872 = (_e17854 * _e17870);
let _e17873 = (_e17855 * _e17870);
let _e17874 = (_e574 - select(_e16765.member, (_e16765.member + _e17847), _e16752));
let _e17875 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e17848), _e16752));
let _e17876 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e17849), _e16752));
let _e17881 = (((_e17874 * _e17871) + (_e17875 * _e17872)) + (_e17876 * _e17873));
let _e17886 = (((_e17874 * _e612) + (_e17875 * _e625)) + (_e17876 * _e638));
let _e17891 = (((_e17871 * _e612) + (_e17872 * _e625)) + (_e17873 * _e638));
let _e17894 = ((_e17872 * _e638) - (_e17873 * _e625));
let _e17897 = ((_e17873 * _e612) - (_e17871 * _e638));
let _e17900 = ((_e17871 * _e625) - (_e17872 * _e612));
let _e17905 = (((_e17894 * _e17894) + (_e17897 * _e17897)) + (_e17900 * _e17900));
let _e17908 = (1f / select(1e-9f, _e17905, (_e17905 > 1e-9f)));
let _e17911 = ((_e17881 - (_e17891 * _e17886)) * _e17908);
let _e17914 = (((_e17891 * _e17881) - _e17886) * _e17908);
let _e17920 = select(0f, _e17911, (((_e17914 >= 0f) && (_e17914 < _e690)) && (_e17911 > 0f)));
let _e17922 = (_e17785 << bitcast<u32>(_e17716));
let _e17934 = (_e17757 + 1i);
let _e17937 = select(_e17934, 0i, (_e17934 < 0i));
let _e17938 = (_e17937 >= _e17732.member);
if _e17938 {
phi_45330_ = (_e17732.member - 1i);
} else {
phi_45330_ = _e17937;
}
let _e17941 = phi_45330_;
if _e17788 {
phi_45341_ = (_e17732.member_1 - 1i);
} else {
phi_45341_ = _e17787;
}
let _e17944 = phi_45341_;
let _e17948 = (((f32(_e17941) + 0.5f) * _e17737) - 0.5f);
let _e17952 = (((f32(_e17944) + 0.5f) * _e17737) - 0.5f);
if _e452 {
phi_45369_ = type_23(_e17944, _e17941);
} else {
phi_45369_ = type_23(_e17941, _e17944);
}
let _e17958 = phi_45369_;
if _e17808 {
phi_45420_ = 0u;
} else {
if (_e14432 == 1u) {
phi_45419_ = 0u;
} else {
if (_e14432 == 2u) {
phi_45418_ = _e17129;
} else {
phi_45418_ = select(_e17135, _e17132, (_e14432 == 3u));
}
let _e17966 = phi_45418_;
phi_45419_ = _e17966;
}
let _e17968 = phi_45419_;
phi_45420_ = _e17968;
}
let _e17970 = phi_45420_;
local_54 = (((bitcast<i32>(_e17970) + _e17958.member_1) * _e17126) + _e17958.member);
let _e17975 = local_54;
let _e17977 = select(_e17152, _e17975, (_e17975 < _e17152));
let _e17982 = global_6.member[bitcast<u32>(select(0i, _e17977, (_e17977 > 0i)))];
let _e17987 = (((((select(_e17948, _e17952, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e17992 = ((1f - (((select(_e17952, _e17948, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e17999 = ((_e16731.member * _e17987) + (_e16739.member * _e17992));
let _e18000 = ((_e16731.member_1 * _e17987) + (_e16739.member_1 * _e17992));
let _e18001 = ((_e16731.member_2 * _e17987) + (_e16739.member_2 * _e17992));
let _e18005 = select((_e16754.member + _e17999), _e16754.member, _e16752);
let _e18006 = select((_e16754.member_1 + _e18000), _e16754.member_1, _e16752);
let _e18007 = select((_e16754.member_2 + _e18001), _e16754.member_2, _e16752);
let _e18018 = (((_e18005 * _e18005) + (_e18006 * _e18006)) + (_e18007 * _e18007));
let _e18022 = (1f / sqrt(select(0f, _e18018, (_e18018 > 0f))));
let _e18023 = (_e18005 * _e18022);
let _e18024 = (_e18006 * _e18022);
let _e18025 = (_e18007 * _e18022);
let _e18026 = (_e574 - select(_e16765.member, (_e16765.member + _e17999), _e16752));
let _e18027 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18000), _e16752));
let _e18028 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18001), _e16752));
let _e18033 = (((_e18026 * _e18023) + (_e18027 * _e18024)) + (_e18028 * _e18025));
let _e18038 = (((_e18026 * _e612) + (_e18027 * _e625)) + (_e18028 * _e638));
let _e18043 = (((_e18023 * _e612) + (_e18024 * _e625)) + (_e18025 * _e638));
let _e18046 = ((_e18024 * _e638) - (_e18025 * _e625));
let _e18049 = ((_e18025 * _e612) - (_e18023 * _e638));
let _e18052 = ((_e18023 * _e625) - (_e18024 * _e612));
let _e18057 = (((_e18046 * _e18046) + (_e18049 * _e18049)) + (_e18052 * _e18052));
let _e18060 = (1f / select(1e-9f, _e18057, (_e18057 > 1e-9f)));
let _e18063 = ((_e18033 - (_e18043 * _e18038)) * _e18060);
let _e18066 = (((_e18043 * _e18033) - _e18038) * _e18060);
let _e18072 = select(0f, _e18063, (((_e18066 >= 0f) && (_e18066 < _e690)) && (_e18063 > 0f)));
let _e18074 = (_e17941 << bitcast<u32>(_e17716));
let _e18086 = (_e17772 + 1i);
if _e17782 {
phi_45967_ = (_e17732.member - 1i);
} else {
phi_45967_ = _e17781;
}
let _e18090 = phi_45967_;
let _e18092 = select(_e18086, 0i, (_e18086 < 0i));
let _e18093 = (_e18092 >= _e17732.member_1);
if _e18093 {
phi_45978_ = (_e17732.member_1 - 1i);
} else {
phi_45978_ = _e18092;
}
let _e18096 = phi_45978_;
let _e18100 = (((f32(_e18090) + 0.5f) * _e17737) - 0.5f);
let _e18104 = (((f32(_e18096) + 0.5f) * _e17737) - 0.5f);
if _e452 {
phi_46006_ = type_23(_e18096, _e18090);
} else {
phi_46006_ = type_23(_e18090, _e18096);
}
let _e18110 = phi_46006_;
if _e17808 {
phi_46057_ = 0u;
} else {
if (_e14432 == 1u) {
phi_46056_ = 0u;
} else {
if (_e14432 == 2u) {
phi_46055_ = _e17129;
} else {
phi_46055_ = select(_e17135, _e17132, (_e14432 == 3u));
}
let _e18118 = phi_46055_;
phi_46056_ = _e18118;
}
let _e18120 = phi_46056_;
phi_46057_ = _e18120;
}
let _e18122 = phi_46057_;
local_52 = (((bitcast<i32>(_e18122) + _e18110.member_1) * _e17126) + _e18110.member);
let _e18127 = local_52;
let _e18129 = select(_e17152, _e18127, (_e18127 < _e17152));
let _e18134 = global_6.member[bitcast<u32>(select(0i, _e18129, (_e18129 > 0i)))];
let _e18139 = (((((select(_e18100, _e18104, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18144 = ((1f - (((select(_e18104, _e18100, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18151 = ((_e16731.member * _e18139) + (_e16739.member * _e18144));
let _e18152 = ((_e16731.member_1 * _e18139) + (_e16739.member_1 * _e18144));
let _e18153 = ((_e16731.member_2 * _e18139) + (_e16739.member_2 * _e18144));
let _e18157 = select((_e16754.member + _e18151), _e16754.member, _e16752);
let _e18158 = select((_e16754.member_1 + _e18152), _e16754.member_1, _e16752);
let _e18159 = select((_e16754.member_2 + _e18153), _e16754.member_2, _e16752);
let _e18170 = (((_e18157 * _e18157) + (_e18158 * _e18158)) + (_e18159 * _e18159));
let _e18174 = (1f / sqrt(select(0f, _e18170, (_e18170 > 0f))));
let _e18175 = (_e18157 * _e18174);
let _e18176 = (_e18158 * _e18174);
let _e18177 = (_e18159 * _e18174);
let _e18178 = (_e574 - select(_e16765.member, (_e16765.member + _e18151), _e16752));
let _e18179 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18152), _e16752));
let _e18180 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18153), _e16752));
let _e18185 = (((_e18178 * _e18175) + (_e18179 * _e18176)) + (_e18180 * _e18177));
let _e18190 = (((_e18178 * _e612) + (_e18179 * _e625)) + (_e18180 * _e638));
let _e18195 = (((_e18175 * _e612) + (_e18176 * _e625)) + (_e18177 * _e638));
let _e18198 = ((_e18176 * _e638) - (_e18177 * _e625));
let _e18201 = ((_e18177 * _e612) - (_e18175 * _e638));
let _e18204 = ((_e18175 * _e625) - (_e18176 * _e612));
let _e18209 = (((_e18198 * _e18198) + (_e18201 * _e18201)) + (_e18204 * _e18204));
let _e18212 = (1f / select(1e-9f, _e18209, (_e18209 > 1e-9f)));
let _e18215 = ((_e18185 - (_e18195 * _e18190)) * _e18212);
let _e18218 = (((_e18195 * _e18185) - _e18190) * _e18212);
let _e18224 = select(0f, _e18215, (((_e18218 >= 0f) && (_e18218 < _e690)) && (_e18215 > 0f)));
let _e18226 = (_e18090 << bitcast<u32>(_e17716));
if _e17938 {
phi_46604_ = (_e17732.member - 1i);
} else {
phi_46604_ = _e17937;
}
let _e18241 = phi_46604_;
if _e18093 {
phi_46615_ = (_e17732.member_1 - 1i);
} else {
phi_46615_ = _e18092;
}
let _e18244 = phi_46615_;
let _e18248 = (((f32(_e18241) + 0.5f) * _e17737) - 0.5f);
let _e18252 = (((f32(_e18244) + 0.5f) * _e17737) - 0.5f);
if _e452 {
phi_46643_ = type_23(_e18244, _e18241);
} else {
phi_46643_ = type_23(_e18241, _e18244);
}
let _e18258 = phi_46643_;
if _e17808 {
phi_46694_ = 0u;
} else {
if (_e14432 == 1u) {
phi_46693_ = 0u;
} else {
if (_e14432 == 2u) {
phi_46692_ = _e17129;
} else {
phi_46692_ = select(_e17135, _e17132, (_e14432 == 3u));
}
let _e18266 = phi_46692_;
phi_46693_ = _e18266;
}
let _e18268 = phi_46693_;
phi_46694_ = _e18268;
}
let _e18270 = phi_46694_;
local_50 = (((bitcast<i32>(_e18270) + _e18258.member_1) * _e17126) + _e18258.member);
let _e18275 = local_50;
let _e18277 = select(_e17152, _e18275, (_e18275 < _e17152));
let _e18282 = global_6.member[bitcast<u32>(select(0i, _e18277, (_e18277 > 0i)))];
let _e18287 = (((((select(_e18248, _e18252, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18292 = ((1f - (((select(_e18252, _e18248, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18299 = ((_e16731.member * _e18287) + (_e16739.member * _e18292));
let _e18300 = ((_e16731.member_1 * _e18287) + (_e16739.member_1 * _e18292));
let _e18301 = ((_e16731.member_2 * _e18287) + (_e16739.member_2 * _e18292));
let _e18305 = select((_e16754.member + _e18299), _e16754.member, _e16752);
let _e18306 = select((_e16754.member_1 + _e18300), _e16754.member_1, _e16752);
let _e18307 = select((_e16754.member_2 + _e18301), _e16754.member_2, _e16752);
let _e18318 = (((_e18305 * _e18305) + (_e18306 * _e18306)) + (_e18307 * _e18307));
let _e18322 = (1f / sqrt(select(0f, _e18318, (_e18318 > 0f))));
let _e18323 = (_e18305 * _e18322);
let _e18324 = (_e18306 * _e18322);
let _e18325 = (_e18307 * _e18322);
let _e18326 = (_e574 - select(_e16765.member, (_e16765.member + _e18299), _e16752));
let _e18327 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18300), _e16752));
let _e18328 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18301), _e16752));
let _e18333 = (((_e18326 * _e18323) + (_e18327 * _e18324)) + (_e18328 * _e18325));
let _e18338 = (((_e18326 * _e612) + (_e18327 * _e625)) + (_e18328 * _e638));
let _e18343 = (((_e18323 * _e612) + (_e18324 * _e625)) + (_e18325 * _e638));
let _e18346 = ((_e18324 * _e638) - (_e18325 * _e625));
let _e18349 = ((_e18325 * _e612) - (_e18323 * _e638));
let _e18352 = ((_e18323 * _e625) - (_e18324 * _e612));
let _e18357 = (((_e18346 * _e18346) + (_e18349 * _e18349)) + (_e18352 * _e18352));
let _e18360 = (1f / select(1e-9f, _e18357, (_e18357 > 1e-9f)));
let _e18363 = ((_e18333 - (_e18343 * _e18338)) * _e18360);
let _e18366 = (((_e18343 * _e18333) - _e18338) * _e18360);
let _e18372 = select(0f, _e18363, (((_e18366 >= 0f) && (_e18366 < _e690)) && (_e18363 > 0f)));
let _e18374 = (_e18241 << bitcast<u32>(_e17716));
let _e18386 = select(((((_e17715 - select(0f, (_e17777 * _e17778), (((select(select(_e765, _e926, (_e17922 >= _e691)), _e846, (_e17922 < _e297)) == _e14432) && (_e17920 > 0f)) && (_e17920 < _e17830)))) - select(0f, (_e17774 * _e17778), (((select(select(_e765, _e926, (_e18074 >= _e691)), _e846, (_e18074 < _e297)) == _e14432) && (_e18072 > 0f)) && (_e18072 < _e17982)))) - select(0f, (_e17777 * _e17776), (((select(select(_e765, _e926, (_e18226 >= _e691)), _e846, (_e18226 < _e297)) == _e14432) && (_e18224 > 0f)) && (_e18224 < _e18134)))) - select(0f, (_e17774 * _e17776), (((select(select(_e765, _e926, (_e18374 >= _e691)), _e846, (_e18374 < _e297)) == _e14432) && (_e18372 > 0f)) && (_e18372 < _e18282)))), _e17715, _e17808);
let _e18387 = (_e14436 & 31u);
let _e18389 = (1u << bitcast<u32>(_e18387));
let _e18398 = bitcast<i32>((((_e14375 + _e18389) - 1u) >> bitcast<u32>(_e18387)));
let _e18399 = bitcast<i32>((((_e14378 + _e18389) - 1u) >> bitcast<u32>(_e18387)));
if _e452 {
phi_47259_ = type_23(_e18399, _e18398);
} else {
phi_47259_ = type_23(_e18398, _e18399);
}
let _e18403 = phi_47259_;
let _e18408 = f32((1i << bitcast<u32>(_e18387)));
let _e18409 = (1f / _e18408);
let _e18411 = ((_e16539 * _e18409) - 0.5f);
let _e18413 = ((_e16632 * _e18409) - 0.5f);
let _e18415 = select(-1f, _e18411, (_e18411 > -1f));
let _e18417 = select(1e6f, _e18415, (_e18415 < 1e6f));
let _e18424 = select(0i, select(select(i32(_e18417), i32(-2147483648), (_e18417 < -2147483600f)), 2147483647i, (_e18417 > 2147483500f)), (_e18417 == _e18417));
let _e18428 = (_e18424 - select(0i, 1i, (_e18417 < f32(_e18424))));
let _e18430 = select(-1f, _e18413, (_e18413 > -1f));
let _e18432 = select(1e6f, _e18430, (_e18430 < 1e6f));
let _e18439 = select(0i, select(select(i32(_e18432), i32(-2147483648), (_e18432 < -2147483600f)), 2147483647i, (_e18432 > 2147483500f)), (_e18432 == _e18432));
let _e18443 = (_e18439 - select(0i, 1i, (_e18432 < f32(_e18439))));
let _e18445 = (_e18411 - f32(_e18428));
let _e18447 = (_e18413 - f32(_e18443));
let _e18448 = (1f - _e18445);
let _e18449 = (1f - _e18447);
let _e18452 = select(_e18428, 0i, (_e18428 < 0i));
let _e18453 = (_e18452 >= _e18403.member);
if _e18453 {
phi_47337_ = (_e18403.member - 1i);
} else {
phi_47337_ = _e18452;
}
let _e18456 = phi_47337_;
let _e18458 = select(_e18443, 0i, (_e18443 < 0i));
let _e18459 = (_e18458 >= _e18403.member_1);
if _e18459 {
phi_47348_ = (_e18403.member_1 - 1i);
} else {
phi_47348_ = _e18458;
}
let _e18462 = phi_47348_;
let _e18466 = (((f32(_e18456) + 0.5f) * _e18408) - 0.5f);
let _e18470 = (((f32(_e18462) + 0.5f) * _e18408) - 0.5f);
if _e452 {
phi_47376_ = type_23(_e18462, _e18456);
} else {
phi_47376_ = type_23(_e18456, _e18462);
}
let _e18476 = phi_47376_;
let _e18479 = (_e14436 == 0u);
if _e18479 {
phi_47427_ = 0u;
} else {
if (_e14436 == 1u) {
phi_47426_ = 0u;
} else {
if (_e14436 == 2u) {
phi_47425_ = _e17129;
} else {
phi_47425_ = select(_e17135, _e17132, (_e14436 == 3u));
}
let _e18485 = phi_47425_;
phi_47426_ = _e18485;
}
let _e18487 = phi_47426_;
phi_47427_ = _e18487;
}
let _e18489 = phi_47427_;
local_48 = (((bitcast<i32>(_e18489) + _e18476.member_1) * _e17126) + _e18476.member);
let _e18494 = local_48;
let _e18496 = select(_e17152, _e18494, (_e18494 < _e17152));
let _e18501 = global_6.member[bitcast<u32>(select(0i, _e18496, (_e18496 > 0i)))];
let _e18506 = (((((select(_e18466, _e18470, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18511 = ((1f - (((select(_e18470, _e18466, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18518 = ((_e16731.member * _e18506) + (_e16739.member * _e18511));
let _e18519 = ((_e16731.member_1 * _e18506) + (_e16739.member_1 * _e18511));
let _e18520 = ((_e16731.member_2 * _e18506) + (_e16739.member_2 * _e18511));
let _e18524 = select((_e16754.member + _e18518), _e16754.member, _e16752);
let _e18525 = select((_e16754.member_1 + _e18519), _e16754.member_1, _e16752);
let _e18526 = select((_e16754.member_2 + _e18520), _e16754.member_2, _e16752);
let _e18537 = (((_e18524 * _e18524) + (_e18525 * _e18525)) + (_e18526 * _e18526));
let _e18541 = (1f / sqrt(select(0f, _e18537, (_e18537 > 0f))));
let _e18542 = (_e18524 * _e18541);
let _e18543 = (_e18525 * _e18541);
let _e18544 = (_e18526 * _e18541);
let _e18545 = (_e574 - select(_e16765.member, (_e16765.member + _e18518), _e16752));
let _e18546 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18519), _e16752));
let _e18547 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18520), _e16752));
let _e18552 = (((_e18545 * _e18542) + (_e18546 * _e18543)) + (_e18547 * _e18544));
let _e18557 = (((_e18545 * _e612) + (_e18546 * _e625)) + (_e18547 * _e638));
let _e18562 = (((_e18542 * _e612) + (_e18543 * _e625)) + (_e18544 * _e638));
let _e18565 = ((_e18543 * _e638) - (_e18544 * _e625));
let _e18568 = ((_e18544 * _e612) - (_e18542 * _e638));
let _e18571 = ((_e18542 * _e625) - (_e18543 * _e612));
let _e18576 = (((_e18565 * _e18565) + (_e18568 * _e18568)) + (_e18571 * _e18571));
let _e18579 = (1f / select(1e-9f, _e18576, (_e18576 > 1e-9f)));
let _e18582 = ((_e18552 - (_e18562 * _e18557)) * _e18579);
let _e18585 = (((_e18562 * _e18552) - _e18557) * _e18579);
let _e18591 = select(0f, _e18582, (((_e18585 >= 0f) && (_e18585 < _e690)) && (_e18582 > 0f)));
let _e18593 = (_e18456 << bitcast<u32>(_e18387));
let _e18605 = (_e18428 + 1i);
let _e18608 = select(_e18605, 0i, (_e18605 < 0i));
let _e18609 = (_e18608 >= _e18403.member);
if _e18609 {
phi_47974_ = (_e18403.member - 1i);
} else {
phi_47974_ = _e18608;
}
let _e18612 = phi_47974_;
if _e18459 {
phi_47985_ = (_e18403.member_1 - 1i);
} else {
phi_47985_ = _e18458;
}
let _e18615 = phi_47985_;
let _e18619 = (((f32(_e18612) + 0.5f) * _e18408) - 0.5f);
let _e18623 = (((f32(_e18615) + 0.5f) * _e18408) - 0.5f);
if _e452 {
phi_48013_ = type_23(_e18615, _e18612);
} else {
phi_48013_ = type_23(_e18612, _e18615);
}
let _e18629 = phi_48013_;
if _e18479 {
phi_48064_ = 0u;
} else {
if (_e14436 == 1u) {
phi_48063_ = 0u;
} else {
if (_e14436 == 2u) {
phi_48062_ = _e17129;
} else {
phi_48062_ = select(_e17135, _e17132, (_e14436 == 3u));
}
let _e18637 = phi_48062_;
phi_48063_ = _e18637;
}
let _e18639 = phi_48063_;
phi_48064_ = _e18639;
}
let _e18641 = phi_48064_;
local_46 = (((bitcast<i32>(_e18641) + _e18629.member_1) * _e17126) + _e18629.member);
let _e18646 = local_46;
let _e18648 = select(_e17152, _e18646, (_e18646 < _e17152));
let _e18653 = global_6.member[bitcast<u32>(select(0i, _e18648, (_e18648 > 0i)))];
let _e18658 = (((((select(_e18619, _e18623, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18663 = ((1f - (((select(_e18623, _e18619, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18670 = ((_e16731.member * _e18658) + (_e16739.member * _e18663));
let _e18671 = ((_e16731.member_1 * _e18658) + (_e16739.member_1 * _e18663));
let _e18672 = ((_e16731.member_2 * _e18658) + (_e16739.member_2 * _e18663));
let _e18676 = select((_e16754.member + _e18670), _e16754.member, _e16752);
let _e18677 = select((_e16754.member_1 + _e18671), _e16754.member_1, _e16752);
let _e18678 = select((_e16754.member_2 + _e18672), _e16754.member_2, _e16752);
let _e18689 = (((_e18676 * _e18676) + (_e18677 * _e18677)) + (_e18678 * _e18678));
let _e18693 = (1f / sqrt(select(0f, _e18689, (_e18689 > 0f))));
let _e18694 = (_e18676 * _e18693);
let _e18695 = (_e18677 * _e18693);
let _e18696 = (_e18678 * _e18693);
let _e18697 = (_e574 - select(_e16765.member, (_e16765.member + _e18670), _e16752));
let _e18698 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18671), _e16752));
let _e18699 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18672), _e16752));
let _e18704 = (((_e18697 * _e18694) + (_e18698 * _e18695)) + (_e18699 * _e18696));
let _e18709 = (((_e18697 * _e612) + (_e18698 * _e625)) + (_e18699 * _e638));
let _e18714 = (((_e18694 * _e612) + (_e18695 * _e625)) + (_e18696 * _e638));
let _e18717 = ((_e18695 * _e638) - (_e18696 * _e625));
let _e18720 = ((_e18696 * _e612) - (_e18694 * _e638));
let _e18723 = ((_e18694 * _e625) - (_e18695 * _e612));
let _e18728 = (((_e18717 * _e18717) + (_e18720 * _e18720)) + (_e18723 * _e18723));
let _e18731 = (1f / select(1e-9f, _e18728, (_e18728 > 1e-9f)));
let _e18734 = ((_e18704 - (_e18714 * _e18709)) * _e18731);
let _e18737 = (((_e18714 * _e18704) - _e18709) * _e18731);
let _e18743 = select(0f, _e18734, (((_e18737 >= 0f) && (_e18737 < _e690)) && (_e18734 > 0f)));
let _e18745 = (_e18612 << bitcast<u32>(_e18387));
let _e18757 = (_e18443 + 1i);
if _e18453 {
phi_48611_ = (_e18403.member - 1i);
} else {
phi_48611_ = _e18452;
}
let _e18761 = phi_48611_;
let _e18763 = select(_e18757, 0i, (_e18757 < 0i));
let _e18764 = (_e18763 >= _e18403.member_1);
if _e18764 {
phi_48622_ = (_e18403.member_1 - 1i);
} else {
phi_48622_ = _e18763;
}
let _e18767 = phi_48622_;
let _e18771 = (((f32(_e18761) + 0.5f) * _e18408) - 0.5f);
let _e18775 = (((f32(_e18767) + 0.5f) * _e18408) - 0.5f);
if _e452 {
phi_48650_ = type_23(_e18767, _e18761);
} else {
phi_48650_ = type_23(_e18761, _e18767);
}
let _e18781 = phi_48650_;
if _e18479 {
phi_48701_ = 0u;
} else {
if (_e14436 == 1u) {
phi_48700_ = 0u;
} else {
if (_e14436 == 2u) {
phi_48699_ = _e17129;
} else {
phi_48699_ = select(_e17135, _e17132, (_e14436 == 3u));
}
let _e18789 = phi_48699_;
phi_48700_ = _e18789;
}
let _e18791 = phi_48700_;
phi_48701_ = _e18791;
}
let _e18793 = phi_48701_;
local_44 = (((bitcast<i32>(_e18793) + _e18781.member_1) * _e17126) + _e18781.member);
let _e18798 = local_44;
let _e18800 = select(_e17152, _e18798, (_e18798 < _e17152));
let _e18805 = global_6.member[bitcast<u32>(select(0i, _e18800, (_e18800 > 0i)))];
let _e18810 = (((((select(_e18771, _e18775, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18815 = ((1f - (((select(_e18775, _e18771, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18822 = ((_e16731.member * _e18810) + (_e16739.member * _e18815));
let _e18823 = ((_e16731.member_1 * _e18810) + (_e16739.member_1 * _e18815));
let _e18824 = ((_e16731.member_2 * _e18810) + (_e16739.member_2 * _e18815));
let _e18828 = select((_e16754.member + _e18822), _e16754.member, _e16752);
let _e18829 = select((_e16754.member_1 + _e18823), _e16754.member_1, _e16752);
let _e18830 = select((_e16754.member_2 + _e18824), _e16754.member_2, _e16752);
let _e18841 = (((_e18828 * _e18828) + (_e18829 * _e18829)) + (_e18830 * _e18830));
let _e18845 = (1f / sqrt(select(0f, _e18841, (_e18841 > 0f))));
let _e18846 = (_e18828 * _e18845);
let _e18847 = (_e18829 * _e18845);
let _e18848 = (_e18830 * _e18845);
let _e18849 = (_e574 - select(_e16765.member, (_e16765.member + _e18822), _e16752));
let _e18850 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18823), _e16752));
let _e18851 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18824), _e16752));
let _e18856 = (((_e18849 * _e18846) + (_e18850 * _e18847)) + (_e18851 * _e18848));
let _e18861 = (((_e18849 * _e612) + (_e18850 * _e625)) + (_e18851 * _e638));
let _e18866 = (((_e18846 * _e612) + (_e18847 * _e625)) + (_e18848 * _e638));
let _e18869 = ((_e18847 * _e638) - (_e18848 * _e625));
let _e18872 = ((_e18848 * _e612) - (_e18846 * _e638));
let _e18875 = ((_e18846 * _e625) - (_e18847 * _e612));
let _e18880 = (((_e18869 * _e18869) + (_e18872 * _e18872)) + (_e18875 * _e18875));
let _e18883 = (1f / select(1e-9f, _e18880, (_e18880 > 1e-9f)));
let _e18886 = ((_e18856 - (_e18866 * _e18861)) * _e18883);
let _e18889 = (((_e18866 * _e18856) - _e18861) * _e18883);
let _e18895 = select(0f, _e18886, (((_e18889 >= 0f) && (_e18889 < _e690)) && (_e18886 > 0f)));
let _e18897 = (_e18761 << bitcast<u32>(_e18387));
if _e18609 {
phi_49248_ = (_e18403.member - 1i);
} else {
phi_49248_ = _e18608;
}
let _e18912 = phi_49248_;
if _e18764 {
phi_49259_ = (_e18403.member_1 - 1i);
} else {
phi_49259_ = _e18763;
}
let _e18915 = phi_49259_;
let _e18919 = (((f32(_e18912) + 0.5f) * _e18408) - 0.5f);
let _e18923 = (((f32(_e18915) + 0.5f) * _e18408) - 0.5f);
if _e452 {
phi_49287_ = type_23(_e18915, _e18912);
} else {
phi_49287_ = type_23(_e18912, _e18915);
}
let _e18929 = phi_49287_;
if _e18479 {
phi_49338_ = 0u;
} else {
if (_e14436 == 1u) {
phi_49337_ = 0u;
} else {
if (_e14436 == 2u) {
phi_49336_ = _e17129;
} else {
phi_49336_ = select(_e17135, _e17132, (_e14436 == 3u));
}
let _e18937 = phi_49336_;
phi_49337_ = _e18937;
}
let _e18939 = phi_49337_;
phi_49338_ = _e18939;
}
let _e18941 = phi_49338_;
local_42 = (((bitcast<i32>(_e18941) + _e18929.member_1) * _e17126) + _e18929.member);
let _e18946 = local_42;
let _e18948 = select(_e17152, _e18946, (_e18946 < _e17152));
let _e18953 = global_6.member[bitcast<u32>(select(0i, _e18948, (_e18948 > 0i)))];
let _e18958 = (((((select(_e18919, _e18923, _e452) + 0.5f) / _e16712) * 2f) - 1f) * _e16720);
let _e18963 = ((1f - (((select(_e18923, _e18919, _e452) + 0.5f) / _e16713) * 2f)) * _e16728);
let _e18970 = ((_e16731.member * _e18958) + (_e16739.member * _e18963));
let _e18971 = ((_e16731.member_1 * _e18958) + (_e16739.member_1 * _e18963));
let _e18972 = ((_e16731.member_2 * _e18958) + (_e16739.member_2 * _e18963));
let _e18976 = select((_e16754.member + _e18970), _e16754.member, _e16752);
let _e18977 = select((_e16754.member_1 + _e18971), _e16754.member_1, _e16752);
let _e18978 = select((_e16754.member_2 + _e18972), _e16754.member_2, _e16752);
let _e18989 = (((_e18976 * _e18976) + (_e18977 * _e18977)) + (_e18978 * _e18978));
let _e18993 = (1f / sqrt(select(0f, _e18989, (_e18989 > 0f))));
let _e18994 = (_e18976 * _e18993);
let _e18995 = (_e18977 * _e18993);
let _e18996 = (_e18978 * _e18993);
let _e18997 = (_e574 - select(_e16765.member, (_e16765.member + _e18970), _e16752));
let _e18998 = (_e586 - select(_e16765.member_1, (_e16765.member_1 + _e18971), _e16752));
let _e18999 = (_e599 - select(_e16765.member_2, (_e16765.member_2 + _e18972), _e16752));
let _e19004 = (((_e18997 * _e18994) + (_e18998 * _e18995)) + (_e18999 * _e18996));
let _e19009 = (((_e18997 * _e612) + (_e18998 * _e625)) + (_e18999 * _e638));
let _e19014 = (((_e18994 * _e612) + (_e18995 * _e625)) + (_e18996 * _e638));
let _e19017 = ((_e18995 * _e638) - (_e18996 * _e625));
let _e19020 = ((_e18996 * _e612) - (_e18994 * _e638));
let _e19023 = ((_e18994 * _e625) - (_e18995 * _e612));
let _e19028 = (((_e19017 * _e19017) + (_e19020 * _e19020)) + (_e19023 * _e19023));
let _e19031 = (1f / select(1e-9f, _e19028, (_e19028 > 1e-9f)));
let _e19034 = ((_e19004 - (_e19014 * _e19009)) * _e19031);
let _e19037 = (((_e19014 * _e19004) - _e19009) * _e19031);
let _e19043 = select(0f, _e19034, (((_e19037 >= 0f) && (_e19037 < _e690)) && (_e19034 > 0f)));
let _e19045 = (_e18912 << bitcast<u32>(_e18387));
let _e19057 = select(((((_e18386 - select(0f, (_e18448 * _e18449), (((select(select(_e765, _e926, (_e18593 >= _e691)), _e846, (_e18593 < _e297)) == _e14436) && (_e18591 > 0f)) && (_e18591 < _e18501)))) - select(0f, (_e18445 * _e18449), (((select(select(_e765, _e926, (_e18745 >= _e691)), _e846, (_e18745 < _e297)) == _e14436) && (_e18743 > 0f)) && (_e18743 < _e18653)))) - select(0f, (_e18448 * _e18447), (((select(select(_e765, _e926, (_e18897 >= _e691)), _e846, (_e18897 < _e297)) == _e14436) && (_e18895 > 0f)) && (_e18895 < _e18805)))) - select(0f, (_e18445 * _e18447), (((select(select(_e765, _e926, (_e19045 >= _e691)), _e846, (_e19045 < _e297)) == _e14436) && (_e19043 > 0f)) && (_e19043 < _e18953)))), _e18386, _e18479);
if _e452 {
phi_49894_ = type_23(_e16629, _e16537);
} else {
phi_49894_ = type_23(_e16537, _e16629);
}
let _e19072 = phi_49894_;
let _e19075 = (_e16630 && (((_e17030 > 0f) && (_e17030 < _e16709)) && (bitcast<f32>((bitcast<u32>(_e19057) & 2147483647u)) > 1e-6f)));
let _e19078 = global_1.member.member_18.member;
let _e19079 = (((select(_e16655, (1f - _e16655), (_e16640 >= 0f)) - select(_e16674, (1f - _e16674), (_e16659 >= 0f))) * (1f / _e16637)) * _e19078);
let _e19083 = select(0f, (((((_e651 * _e16867.member) * ((1f + (_e16907 * (1f + (_e16907 * (0.5f + (_e16907 * (0.16666667f + (_e16907 * (0.041666668f + (_e16907 * (0.008333334f + (_e16907 * (0.001388889f + (_e16907 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16902 + 127i)) << bitcast<u32>(23i))))) * _e16860) * _e19057) * _e19079), _e19075);
let _e19084 = select(0f, (((((_e664 * _e16867.member_1) * ((1f + (_e16955 * (1f + (_e16955 * (0.5f + (_e16955 * (0.16666667f + (_e16955 * (0.041666668f + (_e16955 * (0.008333334f + (_e16955 * (0.001388889f + (_e16955 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16950 + 127i)) << bitcast<u32>(23i))))) * _e16860) * _e19057) * _e19079), _e19075);
let _e19085 = select(0f, (((((_e677 * _e16867.member_2) * ((1f + (_e17003 * (1f + (_e17003 * (0.5f + (_e17003 * (0.16666667f + (_e17003 * (0.041666668f + (_e17003 * (0.008333334f + (_e17003 * (0.001388889f + (_e17003 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e16998 + 127i)) << bitcast<u32>(23i))))) * _e16860) * _e19057) * _e19079), _e19075);
let _e19089 = (bitcast<f32>((bitcast<u32>(_e19083) & 2147483647u)) >= 1073741800f);
let _e19090 = (1f / 1048576f);
let _e19093 = ((_e19083 * select(1f, _e19090, _e19089)) + 0.5f);
let _e19095 = select(-1073741800f, _e19093, (_e19093 > -1073741800f));
let _e19097 = select(1073741800f, _e19095, (_e19095 < 1073741800f));
let _e19104 = select(0i, select(select(i32(_e19097), i32(-2147483648), (_e19097 < -2147483600f)), 2147483647i, (_e19097 > 2147483500f)), (_e19097 == _e19097));
let _e19108 = (_e19104 - select(0i, 1i, (_e19097 < f32(_e19104))));
let _e19109 = select(0i, 20i, _e19089);
let _e19113 = (bitcast<u32>(_e19108) << bitcast<u32>((_e19109 & 31i)));
let _e19120 = bitcast<u32>(((_e19108 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19109) & 31i))));
let _e19124 = (bitcast<f32>((bitcast<u32>(_e19084) & 2147483647u)) >= 1073741800f);
let _e19127 = ((_e19084 * select(1f, _e19090, _e19124)) + 0.5f);
let _e19129 = select(-1073741800f, _e19127, (_e19127 > -1073741800f));
let _e19131 = select(1073741800f, _e19129, (_e19129 < 1073741800f));
let _e19138 = select(0i, select(select(i32(_e19131), i32(-2147483648), (_e19131 < -2147483600f)), 2147483647i, (_e19131 > 2147483500f)), (_e19131 == _e19131));
let _e19142 = (_e19138 - select(0i, 1i, (_e19131 < f32(_e19138))));
let _e19143 = select(0i, 20i, _e19124);
let _e19147 = (bitcast<u32>(_e19142) << bitcast<u32>((_e19143 & 31i)));
let _e19154 = bitcast<u32>(((_e19142 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19143) & 31i))));
let _e19158 = (bitcast<f32>((bitcast<u32>(_e19085) & 2147483647u)) >= 1073741800f);
let _e19161 = ((_e19085 * select(1f, _e19090, _e19158)) + 0.5f);
let _e19163 = select(-1073741800f, _e19161, (_e19161 > -1073741800f));
let _e19165 = select(1073741800f, _e19163, (_e19163 < 1073741800f));
let _e19172 = select(0i, select(select(i32(_e19165), i32(-2147483648), (_e19165 < -2147483600f)), 2147483647i, (_e19165 > 2147483500f)), (_e19165 == _e19165));
let _e19176 = (_e19172 - select(0i, 1i, (_e19165 < f32(_e19172))));
let _e19177 = select(0i, 20i, _e19158);
let _e19181 = (bitcast<u32>(_e19176) << bitcast<u32>((_e19177 & 31i)));
let _e19188 = bitcast<u32>(((_e19176 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19177) & 31i))));
let _e19193 = bitcast<i32>(bitcast<u32>((((_e19072.member_1 * _e14379) + _e19072.member) * 6i)));
if ((_e19113 | _e19120) == 0u) {
} else {
let _e19196 = bitcast<u32>(_e19193);
if (_e19196 < _e269) {
let _e19200 = atomicAdd((&global_8.member[_e19196]), _e19113);
phi_50127_ = _e19200;
} else {
phi_50127_ = 0u;
}
let _e19202 = phi_50127_;
let _e19206 = (_e19120 + select(0u, 1u, ((_e19202 + _e19113) < _e19113)));
if (_e19206 == 0u) {
} else {
let _e19208 = (_e19196 + 1u);
if (_e19208 < _e269) {
let _e19212 = atomicAdd((&global_8.member[_e19208]), _e19206);
}
}
}
if ((_e19147 | _e19154) == 0u) {
} else {
let _e19216 = bitcast<u32>((_e19193 + 2i));
if (_e19216 < _e269) {
let _e19220 = atomicAdd((&global_8.member[_e19216]), _e19147);
phi_50157_ = _e19220;
} else {
phi_50157_ = 0u;
}
let _e19222 = phi_50157_;
let _e19226 = (_e19154 + select(0u, 1u, ((_e19222 + _e19147) < _e19147)));
if (_e19226 == 0u) {
} else {
let _e19228 = (_e19216 + 1u);
if (_e19228 < _e269) {
let _e19232 = atomicAdd((&global_8.member[_e19228]), _e19226);
}
}
}
if ((_e19181 | _e19188) == 0u) {
} else {
let _e19236 = bitcast<u32>((_e19193 + 4i));
if (_e19236 < _e269) {
let _e19240 = atomicAdd((&global_8.member[_e19236]), _e19181);
phi_50187_ = _e19240;
} else {
phi_50187_ = 0u;
}
let _e19242 = phi_50187_;
let _e19246 = (_e19188 + select(0u, 1u, ((_e19242 + _e19181) < _e19181)));
if (_e19246 == 0u) {
} else {
let _e19248 = (_e19236 + 1u);
if (_e19248 < _e269) {
let _e19252 = atomicAdd((&global_8.member[_e19248]), _e19246);
}
}
}
phi_41291_ = (_e16627 + 1i);
} else {
phi_41291_ = i32();
}
let _e19255 = phi_41291_;
continue;
continuing {
phi_41290_ = _e19255;
break if !(_e16630);
}
}
phi_41137_ = (_e16534 + 1i);
} else {
phi_41137_ = i32();
}
let _e19259 = phi_41137_;
continue;
continuing {
phi_41136_ = _e19259;
break if !(_e16535);
}
}
}
}
} else {
let _e19261 = (_e765 & 31u);
let _e19263 = (1u << bitcast<u32>(_e19261));
let _e19272 = bitcast<i32>((((_e14375 + _e19263) - 1u) >> bitcast<u32>(_e19261)));
let _e19273 = bitcast<i32>((((_e14378 + _e19263) - 1u) >> bitcast<u32>(_e19261)));
if _e452 {
phi_50253_ = type_23(_e19273, _e19272);
} else {
phi_50253_ = type_23(_e19272, _e19273);
}
let _e19277 = phi_50253_;
let _e19281 = (_e14405 >> bitcast<u32>(_e19261));
if (_e19281 < _e19277.member) {
phi_50328_ = _e19281;
} else {
phi_50328_ = (_e19277.member - 1i);
}
let _e19287 = phi_50328_;
phi_50332_ = type_23(2147483647i, -1i);
phi_50335_ = 0i;
loop {
let _e19290 = phi_50332_;
let _e19292 = phi_50335_;
local_233 = _e19290;
local_234 = _e19290;
let _e19293 = (_e19292 < 16i);
if _e19293 {
let _e19295 = (1i << bitcast<u32>(_e19261));
let _e19296 = f32(_e19295);
let _e19298 = ((4u - _e765) & 31u);
let _e19303 = ((_e14423 >> bitcast<u32>(_e19261)) + (_e19292 & ((1i << bitcast<u32>(_e19298)) - 1i)));
let _e19307 = (((f32(_e19303) + 0.5f) * _e19296) - 0.5f);
let _e19311 = (-(((_e415 * _e19307) + _e441)) / _e428);
let _e19318 = bitcast<f32>((bitcast<u32>(((_e465 * _e19307) + ((_e478 * _e19311) + _e491))) & 2147483647u));
let _e19325 = bitcast<f32>((bitcast<u32>(((_e504 * _e19307) + ((_e517 * _e19311) + _e530))) & 2147483647u));
let _e19330 = (((0.5f * (_e19318 + _e19325)) / _e533) + (0.5f * _e19296));
let _e19331 = (1f / _e19296);
let _e19339 = ((((_e19311 + _e19330) + 0.5f) * _e19331) - 0.5f);
let _e19340 = f32((_e19277.member_1 - 1i));
let _e19341 = (0f - 1f);
let _e19343 = select(_e19341, _e19339, (_e19339 > _e19341));
let _e19345 = select(_e19340, _e19343, (_e19343 < _e19340));
let _e19352 = select(0i, select(select(i32(_e19345), i32(-2147483648), (_e19345 < -2147483600f)), 2147483647i, (_e19345 > 2147483500f)), (_e19345 == _e19345));
let _e19357 = (((((_e19311 - _e19330) + 0.5f) * _e19331) - 0.5f) + 1f);
let _e19358 = (_e19340 + 1f);
let _e19360 = select(0f, _e19357, (_e19357 > 0f));
let _e19362 = select(_e19358, _e19360, (_e19360 < _e19358));
let _e19369 = select(0i, select(select(i32(_e19362), i32(-2147483648), (_e19362 < -2147483600f)), 2147483647i, (_e19362 > 2147483500f)), (_e19362 == _e19362));
let _e19380 = ((1e-4f * _e19296) * _e533);
let _e19382 = select(_e19325, _e19318, (_e19318 > _e19325));
let _e19384 = select(_e19380, _e19382, (_e19382 > _e19380));
let _e19386 = select(_e19325, _e19318, (_e19318 < _e19325));
let _e19388 = select(_e19380, _e19386, (_e19386 > _e19380));
let _e19390 = (0.5f * (_e19384 + _e19388));
let _e19391 = (0.5f / _e19388);
let _e19392 = (1f / _e19384);
phi_50486_ = _e19290;
phi_50489_ = 0i;
loop {
let _e19394 = phi_50486_;
let _e19396 = phi_50489_;
local_242 = _e19394;
let _e19399 = (((_e19369 - select(0i, 1i, (_e19362 < f32(_e19369)))) + (_e19292 >> bitcast<u32>(_e19298))) + (_e19396 << bitcast<u32>(_e19261)));
let _e19400 = (_e19399 <= select(-1i, (_e19352 - select(0i, 1i, (_e19345 < f32(_e19352)))), (_e19303 <= _e19287)));
if _e19400 {
let _e19404 = (((f32(_e19399) + 0.5f) * _e19296) - 0.5f);
let _e19406 = ((_e19404 - _e19311) * _e533);
let _e19407 = (_e533 * _e19296);
let _e19409 = (0.5f * _e19407);
let _e19410 = (_e19406 + _e19409);
let _e19411 = -(_e19410);
let _e19414 = (_e19390 - select(_e19411, _e19410, (_e19410 > _e19411)));
let _e19416 = select(0f, _e19414, (_e19414 > 0f));
let _e19418 = select(_e19388, _e19416, (_e19416 < _e19388));
let _e19421 = (_e19414 - _e19388);
let _e19425 = (((_e19418 * (_e19418 * _e19391)) + select(0f, _e19421, (_e19421 > 0f))) * _e19392);
let _e19429 = (_e19406 - _e19409);
let _e19430 = -(_e19429);
let _e19433 = (_e19390 - select(_e19430, _e19429, (_e19429 > _e19430)));
let _e19435 = select(0f, _e19433, (_e19433 > 0f));
let _e19437 = select(_e19388, _e19435, (_e19435 < _e19388));
let _e19440 = (_e19433 - _e19388);
let _e19444 = (((_e19437 * (_e19437 * _e19391)) + select(0f, _e19440, (_e19440 > 0f))) * _e19392);
if _e452 {
phi_50619_ = type_23(_e19399, _e19303);
} else {
phi_50619_ = type_23(_e19303, _e19399);
}
let _e19455 = phi_50619_;
let _e19461 = bitcast<i32>(((_e14375 + 1u) >> bitcast<u32>(1u)));
let _e19464 = global_1.member.member_18.member_9;
let _e19469 = global_1.member.member_18.member_6;
let _e19472 = global_1.member.member_18.member_7;
let _e19475 = global_1.member.member_18.member_8;
if _e14430 {
phi_50670_ = 0u;
} else {
if (_e765 == 1u) {
phi_50669_ = 0u;
} else {
if (_e765 == 2u) {
phi_50668_ = _e19469;
} else {
phi_50668_ = select(_e19475, _e19472, (_e765 == 3u));
}
let _e19481 = phi_50668_;
phi_50669_ = _e19481;
}
let _e19483 = phi_50669_;
phi_50670_ = _e19483;
}
let _e19485 = phi_50670_;
local_40 = (((bitcast<i32>(_e19485) + _e19455.member_1) * _e19461) + _e19455.member);
local_41 = (_e19461 * bitcast<i32>(_e19464));
let _e19490 = local_40;
let _e19492 = (bitcast<i32>(_e261) - 1i);
let _e19494 = select(_e19492, _e19490, (_e19490 < _e19492));
let _e19499 = global_6.member[bitcast<u32>(select(0i, _e19494, (_e19494 > 0i)))];
let _e19500 = local_41;
let _e19501 = local_40;
let _e19502 = (_e19500 + _e19501);
let _e19504 = select(_e19492, _e19502, (_e19502 < _e19492));
let _e19509 = global_6.member[bitcast<u32>(select(0i, _e19504, (_e19504 > 0i)))];
let _e19510 = local_41;
let _e19512 = local_40;
let _e19513 = ((2i * _e19510) + _e19512);
let _e19515 = select(_e19492, _e19513, (_e19513 < _e19492));
let _e19520 = global_6.member[bitcast<u32>(select(0i, _e19515, (_e19515 > 0i)))];
let _e19522 = (_e19295 >> bitcast<u32>(1i));
let _e19525 = ((_e19455.member << bitcast<u32>(_e19261)) + _e19522);
let _e19528 = ((_e19455.member_1 << bitcast<u32>(_e19261)) + _e19522);
let _e19530 = select(_e19525, 0i, (_e19525 < 0i));
if (_e19530 >= _e14379) {
phi_50796_ = (_e14379 - 1i);
} else {
phi_50796_ = _e19530;
}
let _e19534 = phi_50796_;
let _e19536 = select(_e19528, 0i, (_e19528 < 0i));
if (_e19536 >= _e14380) {
phi_50807_ = (_e14380 - 1i);
} else {
phi_50807_ = _e19536;
}
let _e19540 = phi_50807_;
local_38 = bitcast<i32>((_e14375 * _e14378));
local_39 = ((_e19540 * _e14379) + _e19534);
let _e19545 = local_38;
let _e19546 = local_39;
let _e19547 = (_e19545 + _e19546);
let _e19549 = (bitcast<i32>(_e258) - 1i);
let _e19551 = select(_e19549, _e19547, (_e19547 < _e19549));
let _e19556 = global_5.member[bitcast<u32>(select(0i, _e19551, (_e19551 > 0i)))];
let _e19565 = global_1.member.member_2.member;
let _e19566 = (((((select(_e19307, _e19404, _e452) + 0.5f) / f32(_e14379)) * 2f) - 1f) * _e19565);
let _e19573 = global_1.member.member_2.member_1;
let _e19574 = ((1f - (((select(_e19404, _e19307, _e452) + 0.5f) / f32(_e14380)) * 2f)) * _e19573);
let _e19576 = global_1.member.member_3;
let _e19584 = global_1.member.member_4;
let _e19591 = ((_e19576.member * _e19566) + (_e19584.member * _e19574));
let _e19592 = ((_e19576.member_1 * _e19566) + (_e19584.member_1 * _e19574));
let _e19593 = ((_e19576.member_2 * _e19566) + (_e19584.member_2 * _e19574));
let _e19596 = global_1.member.member_2.member_3;
let _e19597 = (_e19596 != 0u);
let _e19599 = global_1.member.member_5;
let _e19606 = select((_e19599.member + _e19591), _e19599.member, _e19597);
let _e19607 = select((_e19599.member_1 + _e19592), _e19599.member_1, _e19597);
let _e19608 = select((_e19599.member_2 + _e19593), _e19599.member_2, _e19597);
let _e19610 = global_1.member.member_6;
let _e19624 = (((_e19606 * _e19606) + (_e19607 * _e19607)) + (_e19608 * _e19608));
let _e19627 = sqrt(select(0f, _e19624, (_e19624 > 0f)));
let _e19628 = (1f / _e19627);
let _e19629 = (_e19606 * _e19628);
let _e19630 = (_e19607 * _e19628);
let _e19631 = (_e19608 * _e19628);
let _e19632 = (_e574 - select(_e19610.member, (_e19610.member + _e19591), _e19597));
let _e19633 = (_e586 - select(_e19610.member_1, (_e19610.member_1 + _e19592), _e19597));
let _e19634 = (_e599 - select(_e19610.member_2, (_e19610.member_2 + _e19593), _e19597));
let _e19639 = (((_e19632 * _e19629) + (_e19633 * _e19630)) + (_e19634 * _e19631));
let _e19644 = (((_e19632 * _e612) + (_e19633 * _e625)) + (_e19634 * _e638));
let _e19649 = (((_e19629 * _e612) + (_e19630 * _e625)) + (_e19631 * _e638));
let _e19652 = ((_e19630 * _e638) - (_e19631 * _e625));
let _e19655 = ((_e19631 * _e612) - (_e19629 * _e638));
let _e19658 = ((_e19629 * _e625) - (_e19630 * _e612));
let _e19663 = (((_e19652 * _e19652) + (_e19655 * _e19655)) + (_e19658 * _e19658));
let _e19666 = (1f / select(1e-9f, _e19663, (_e19663 > 1e-9f)));
let _e19669 = ((_e19639 - (_e19649 * _e19644)) * _e19666);
let _e19672 = (((_e19649 * _e19639) - _e19644) * _e19666);
let _e19678 = -(_e19649);
let _e19681 = global_1.member.member_13.member_2;
let _e19682 = (_e19681 * _e19681);
let _e19686 = ((1f + _e19682) - ((2f * _e19681) * _e19678));
let _e19688 = select(1e-9f, _e19686, (_e19686 > 1e-9f));
let _e19700 = global_1.member.member_13.member_3;
let _e19705 = (_e19627 * (select(((1f - _e19682) / (_e19688 * sqrt(select(0f, _e19688, (_e19688 > 0f))))), (0.75f * (1f + (_e19678 * _e19678))), (_e19700 == 1u)) * (0.25f / 3.1415927f)));
let _e19706 = (_e19669 - _e19556);
let _e19709 = (_e19672 + select(0f, _e19706, (_e19706 > 0f)));
let _e19712 = global_1.member.member_13.member_1;
let _e19721 = global_1.member.member_13.member;
let _e19726 = -((_e19721.member * _e19709));
let _e19728 = select(-87f, _e19726, (_e19726 > -87f));
let _e19730 = select(88f, _e19728, (_e19728 < 88f));
let _e19732 = ((_e19730 * 1.442695f) + 0.5f);
let _e19734 = select(-127f, _e19732, (_e19732 > -127f));
let _e19736 = select(128f, _e19734, (_e19734 < 128f));
let _e19743 = select(0i, select(select(i32(_e19736), i32(-2147483648), (_e19736 < -2147483600f)), 2147483647i, (_e19736 > 2147483500f)), (_e19736 == _e19736));
let _e19747 = (_e19743 - select(0i, 1i, (_e19736 < f32(_e19743))));
let _e19748 = f32(_e19747);
let _e19752 = ((_e19730 - (_e19748 * 0.6933594f)) - (_e19748 * -2.1219444e-4f));
let _e19774 = -((_e19721.member_1 * _e19709));
let _e19776 = select(-87f, _e19774, (_e19774 > -87f));
let _e19778 = select(88f, _e19776, (_e19776 < 88f));
let _e19780 = ((_e19778 * 1.442695f) + 0.5f);
let _e19782 = select(-127f, _e19780, (_e19780 > -127f));
let _e19784 = select(128f, _e19782, (_e19782 < 128f));
let _e19791 = select(0i, select(select(i32(_e19784), i32(-2147483648), (_e19784 < -2147483600f)), 2147483647i, (_e19784 > 2147483500f)), (_e19784 == _e19784));
let _e19795 = (_e19791 - select(0i, 1i, (_e19784 < f32(_e19791))));
let _e19796 = f32(_e19795);
let _e19800 = ((_e19778 - (_e19796 * 0.6933594f)) - (_e19796 * -2.1219444e-4f));
let _e19822 = -((_e19721.member_2 * _e19709));
let _e19824 = select(-87f, _e19822, (_e19822 > -87f));
let _e19826 = select(88f, _e19824, (_e19824 < 88f));
let _e19828 = ((_e19826 * 1.442695f) + 0.5f);
let _e19830 = select(-127f, _e19828, (_e19828 > -127f));
let _e19832 = select(128f, _e19830, (_e19830 < 128f));
let _e19839 = select(0i, select(select(i32(_e19832), i32(-2147483648), (_e19832 < -2147483600f)), 2147483647i, (_e19832 > 2147483500f)), (_e19832 == _e19832));
let _e19843 = (_e19839 - select(0i, 1i, (_e19832 < f32(_e19839))));
let _e19844 = f32(_e19843);
let _e19848 = ((_e19826 - (_e19844 * 0.6933594f)) - (_e19844 * -2.1219444e-4f));
let _e19875 = select(0f, _e19669, (((_e19672 >= 0f) && (_e19672 < _e690)) && (_e19669 > 0f)));
let _e19878 = ((_e19875 > 0f) && (_e19875 < _e19499));
if _e452 {
phi_51376_ = type_23(_e19399, _e19303);
} else {
phi_51376_ = type_23(_e19303, _e19399);
}
let _e19902 = phi_51376_;
let _e19905 = (_e19400 && _e19878);
let _e19908 = global_1.member.member_18.member;
let _e19909 = (((select(_e19425, (1f - _e19425), (_e19410 >= 0f)) - select(_e19444, (1f - _e19444), (_e19429 >= 0f))) * (1f / _e19407)) * _e19908);
let _e19913 = select(0f, ((((_e651 * _e19712.member) * ((1f + (_e19752 * (1f + (_e19752 * (0.5f + (_e19752 * (0.16666667f + (_e19752 * (0.041666668f + (_e19752 * (0.008333334f + (_e19752 * (0.001388889f + (_e19752 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19747 + 127i)) << bitcast<u32>(23i))))) * _e19705) * _e19909), _e19905);
let _e19914 = select(0f, ((((_e664 * _e19712.member_1) * ((1f + (_e19800 * (1f + (_e19800 * (0.5f + (_e19800 * (0.16666667f + (_e19800 * (0.041666668f + (_e19800 * (0.008333334f + (_e19800 * (0.001388889f + (_e19800 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19795 + 127i)) << bitcast<u32>(23i))))) * _e19705) * _e19909), _e19905);
let _e19915 = select(0f, ((((_e677 * _e19712.member_2) * ((1f + (_e19848 * (1f + (_e19848 * (0.5f + (_e19848 * (0.16666667f + (_e19848 * (0.041666668f + (_e19848 * (0.008333334f + (_e19848 * (0.001388889f + (_e19848 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e19843 + 127i)) << bitcast<u32>(23i))))) * _e19705) * _e19909), _e19905);
let _e19919 = (bitcast<f32>((bitcast<u32>(_e19913) & 2147483647u)) >= 1073741800f);
let _e19920 = (1f / 1048576f);
let _e19923 = ((_e19913 * select(1f, _e19920, _e19919)) + 0.5f);
let _e19925 = select(-1073741800f, _e19923, (_e19923 > -1073741800f));
let _e19927 = select(1073741800f, _e19925, (_e19925 < 1073741800f));
let _e19934 = select(0i, select(select(i32(_e19927), i32(-2147483648), (_e19927 < -2147483600f)), 2147483647i, (_e19927 > 2147483500f)), (_e19927 == _e19927));
let _e19938 = (_e19934 - select(0i, 1i, (_e19927 < f32(_e19934))));
let _e19939 = select(0i, 20i, _e19919);
let _e19943 = (bitcast<u32>(_e19938) << bitcast<u32>((_e19939 & 31i)));
let _e19950 = bitcast<u32>(((_e19938 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19939) & 31i))));
let _e19954 = (bitcast<f32>((bitcast<u32>(_e19914) & 2147483647u)) >= 1073741800f);
let _e19957 = ((_e19914 * select(1f, _e19920, _e19954)) + 0.5f);
let _e19959 = select(-1073741800f, _e19957, (_e19957 > -1073741800f));
let _e19961 = select(1073741800f, _e19959, (_e19959 < 1073741800f));
let _e19968 = select(0i, select(select(i32(_e19961), i32(-2147483648), (_e19961 < -2147483600f)), 2147483647i, (_e19961 > 2147483500f)), (_e19961 == _e19961));
let _e19972 = (_e19968 - select(0i, 1i, (_e19961 < f32(_e19968))));
let _e19973 = select(0i, 20i, _e19954);
let _e19977 = (bitcast<u32>(_e19972) << bitcast<u32>((_e19973 & 31i)));
let _e19984 = bitcast<u32>(((_e19972 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e19973) & 31i))));
let _e19988 = (bitcast<f32>((bitcast<u32>(_e19915) & 2147483647u)) >= 1073741800f);
let _e19991 = ((_e19915 * select(1f, _e19920, _e19988)) + 0.5f);
let _e19993 = select(-1073741800f, _e19991, (_e19991 > -1073741800f));
let _e19995 = select(1073741800f, _e19993, (_e19993 < 1073741800f));
let _e20002 = select(0i, select(select(i32(_e19995), i32(-2147483648), (_e19995 < -2147483600f)), 2147483647i, (_e19995 > 2147483500f)), (_e19995 == _e19995));
let _e20006 = (_e20002 - select(0i, 1i, (_e19995 < f32(_e20002))));
let _e20007 = select(0i, 20i, _e19988);
let _e20011 = (bitcast<u32>(_e20006) << bitcast<u32>((_e20007 & 31i)));
let _e20018 = bitcast<u32>(((_e20006 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20007) & 31i))));
let _e20023 = global_1.member.member_18.member_2;
let _e20026 = global_1.member.member_18.member_3;
let _e20029 = global_1.member.member_18.member_4;
let _e20032 = global_1.member.member_18.member_5;
if _e14430 {
phi_51575_ = 0u;
} else {
if (_e765 == 1u) {
phi_51574_ = _e20023;
} else {
if (_e765 == 2u) {
phi_51573_ = _e20026;
} else {
phi_51573_ = select(_e20032, _e20029, (_e765 == 3u));
}
let _e20038 = phi_51573_;
phi_51574_ = _e20038;
}
let _e20040 = phi_51574_;
phi_51575_ = _e20040;
}
let _e20042 = phi_51575_;
let _e20050 = bitcast<i32>(bitcast<u32>((((bitcast<i32>(_e20042) + (_e19902.member_1 * _e19272)) + _e19902.member) * 6i)));
if ((_e19943 | _e19950) == 0u) {
} else {
let _e20053 = bitcast<u32>(_e20050);
if (_e20053 < _e269) {
let _e20057 = atomicAdd((&global_8.member[_e20053]), _e19943);
phi_51609_ = _e20057;
} else {
phi_51609_ = 0u;
}
let _e20059 = phi_51609_;
let _e20063 = (_e19950 + select(0u, 1u, ((_e20059 + _e19943) < _e19943)));
if (_e20063 == 0u) {
} else {
let _e20065 = (_e20053 + 1u);
if (_e20065 < _e269) {
let _e20069 = atomicAdd((&global_8.member[_e20065]), _e20063);
}
}
}
if ((_e19977 | _e19984) == 0u) {
} else {
let _e20073 = bitcast<u32>((_e20050 + 2i));
if (_e20073 < _e269) {
let _e20077 = atomicAdd((&global_8.member[_e20073]), _e19977);
phi_51639_ = _e20077;
} else {
phi_51639_ = 0u;
}
let _e20079 = phi_51639_;
let _e20083 = (_e19984 + select(0u, 1u, ((_e20079 + _e19977) < _e19977)));
if (_e20083 == 0u) {
} else {
let _e20085 = (_e20073 + 1u);
if (_e20085 < _e269) {
let _e20089 = atomicAdd((&global_8.member[_e20085]), _e20083);
}
}
}
if ((_e20011 | _e20018) == 0u) {
} else {
let _e20093 = bitcast<u32>((_e20050 + 4i));
if (_e20093 < _e269) {
let _e20097 = atomicAdd((&global_8.member[_e20093]), _e20011);
phi_51669_ = _e20097;
} else {
phi_51669_ = 0u;
}
let _e20099 = phi_51669_;
let _e20103 = (_e20018 + select(0u, 1u, ((_e20099 + _e20011) < _e20011)));
if (_e20103 == 0u) {
} else {
let _e20105 = (_e20093 + 1u);
if (_e20105 < _e269) {
let _e20109 = atomicAdd((&global_8.member[_e20105]), _e20103);
}
}
}
let _e20110 = bitcast<i32>(bitcast<u32>(select(-1i, _e19399, (_e19400 && (!(((_e19878 && !(((((_e19303 * _e19295) == _e297) && (_e846 != _e765)) || ((((_e19303 + 1i) * _e19295) == _e691) && (_e926 != _e765))))) && ((_e19875 * (1f + (0.02f * _e19296))) < _e19520))) && (_e19875 <= _e19509))))));
if (_e20110 >= 0i) {
phi_51706_ = type_23(select(_e19394.member, _e20110, (_e20110 < _e19394.member)), select(_e19394.member_1, _e20110, (_e20110 > _e19394.member_1)));
} else {
phi_51706_ = _e19394;
}
let _e20120 = phi_51706_;
phi_50487_ = _e20120;
phi_50490_ = (_e19396 + 1i);
} else {
phi_50487_ = type_23();
phi_50490_ = i32();
}
let _e20123 = phi_50487_;
let _e20125 = phi_50490_;
continue;
continuing {
phi_50486_ = _e20123;
phi_50489_ = _e20125;
break if !(_e19400);
}
}
let _e25490 = local_242;
phi_50333_ = _e25490;
phi_50336_ = (_e19292 + 1i);
} else {
phi_50333_ = type_23();
phi_50336_ = i32();
}
let _e20129 = phi_50333_;
let _e20131 = phi_50336_;
continue;
continuing {
phi_50332_ = _e20129;
phi_50335_ = _e20131;
break if !(_e19293);
}
}
let _e20134 = local_233;
let _e20137 = local_234;
if (_e20134.member <= _e20137.member_1) {
let _e20142 = ((_e20137.member_1 + 1i) << bitcast<u32>(_e19261));
if (_e20142 <= _e14429) {
phi_51723_ = (_e20142 - 1i);
} else {
phi_51723_ = _e14429;
}
let _e20146 = phi_51723_;
let _e20148 = (_e20134.member << bitcast<u32>(_e19261));
let _e20150 = select(_e846, 0u, (_e846 == _e765));
let _e20154 = select(_e926, 0u, ((_e926 == _e765) || (_e926 == _e846)));
let _e20162 = ((select(0u, 1u, (_e765 > 0u)) + select(0u, 1u, (_e20150 > 0u))) + select(0u, 1u, (_e20154 > 0u)));
if (_e20162 == 0u) {
phi_51758_ = 0i;
loop {
let _e20165 = phi_51758_;
let _e20166 = (_e20165 < 16i);
if _e20166 {
let _e20168 = (_e14424 + (_e20165 & 15i));
let _e20172 = (((f32(_e20168) + 0.5f) * 1f) - 0.5f);
let _e20176 = (-(((_e415 * _e20172) + _e441)) / _e428);
let _e20183 = bitcast<f32>((bitcast<u32>(((_e465 * _e20172) + ((_e478 * _e20176) + _e491))) & 2147483647u));
let _e20190 = bitcast<f32>((bitcast<u32>(((_e504 * _e20172) + ((_e517 * _e20176) + _e530))) & 2147483647u));
let _e20194 = (((0.5f * (_e20183 + _e20190)) / _e533) + _e716);
let _e20195 = (1f / 1f);
let _e20203 = ((((_e20176 + _e20194) + 0.5f) * _e20195) - 0.5f);
let _e20204 = f32(_e20148);
let _e20205 = f32(_e20146);
let _e20206 = (_e20204 - 1f);
let _e20208 = select(_e20206, _e20203, (_e20203 > _e20206));
let _e20210 = select(_e20205, _e20208, (_e20208 < _e20205));
let _e20217 = select(0i, select(select(i32(_e20210), i32(-2147483648), (_e20210 < -2147483600f)), 2147483647i, (_e20210 > 2147483500f)), (_e20210 == _e20210));
let _e20222 = (((((_e20176 - _e20194) + 0.5f) * _e20195) - 0.5f) + 1f);
let _e20223 = (_e20205 + 1f);
let _e20225 = select(_e20204, _e20222, (_e20222 > _e20204));
let _e20227 = select(_e20223, _e20225, (_e20225 < _e20223));
let _e20234 = select(0i, select(select(i32(_e20227), i32(-2147483648), (_e20227 < -2147483600f)), 2147483647i, (_e20227 > 2147483500f)), (_e20227 == _e20227));
let _e20245 = ((1e-4f * 1f) * _e533);
let _e20247 = select(_e20190, _e20183, (_e20183 > _e20190));
let _e20249 = select(_e20245, _e20247, (_e20247 > _e20245));
let _e20251 = select(_e20190, _e20183, (_e20183 < _e20190));
let _e20253 = select(_e20245, _e20251, (_e20251 > _e20245));
let _e20255 = (0.5f * (_e20249 + _e20253));
let _e20256 = (0.5f / _e20253);
let _e20257 = (1f / _e20249);
phi_51912_ = 0i;
loop {
let _e20259 = phi_51912_;
let _e20261 = (((_e20234 - select(0i, 1i, (_e20227 < f32(_e20234)))) + (_e20165 >> bitcast<u32>(4u))) + bitcast<i32>(_e20259));
let _e20262 = (_e20261 <= select(-1i, (_e20217 - select(0i, 1i, (_e20210 < f32(_e20217)))), (_e20168 <= _e14428)));
if _e20262 {
let _e20268 = (((((f32(_e20261) + 0.5f) * 1f) - 0.5f) - _e20176) * _e533);
let _e20269 = (_e533 * 1f);
let _e20271 = (0.5f * _e20269);
let _e20272 = (_e20268 + _e20271);
let _e20273 = -(_e20272);
let _e20276 = (_e20255 - select(_e20273, _e20272, (_e20272 > _e20273)));
let _e20278 = select(0f, _e20276, (_e20276 > 0f));
let _e20280 = select(_e20253, _e20278, (_e20278 < _e20253));
let _e20283 = (_e20276 - _e20253);
let _e20287 = (((_e20280 * (_e20280 * _e20256)) + select(0f, _e20283, (_e20283 > 0f))) * _e20257);
let _e20291 = (_e20268 - _e20271);
let _e20292 = -(_e20291);
let _e20295 = (_e20255 - select(_e20292, _e20291, (_e20291 > _e20292)));
let _e20297 = select(0f, _e20295, (_e20295 > 0f));
let _e20299 = select(_e20253, _e20297, (_e20297 < _e20253));
let _e20302 = (_e20295 - _e20253);
let _e20306 = (((_e20299 * (_e20299 * _e20256)) + select(0f, _e20302, (_e20302 > 0f))) * _e20257);
if _e452 {
phi_52017_ = type_23(_e20261, _e20168);
} else {
phi_52017_ = type_23(_e20168, _e20261);
}
let _e20315 = phi_52017_;
local_36 = bitcast<i32>((_e14375 * _e14378));
local_37 = ((_e20315.member_1 * _e14379) + _e20315.member);
let _e20322 = local_36;
let _e20323 = local_37;
let _e20324 = (_e20322 + _e20323);
let _e20326 = (bitcast<i32>(_e258) - 1i);
let _e20328 = select(_e20326, _e20324, (_e20324 < _e20326));
let _e20333 = global_5.member[bitcast<u32>(select(0i, _e20328, (_e20328 > 0i)))];
let _e20334 = local_37;
let _e20336 = select(_e20326, _e20334, (_e20334 < _e20326));
let _e20341 = global_5.member[bitcast<u32>(select(0i, _e20336, (_e20336 > 0i)))];
let _e20352 = global_1.member.member_2.member;
let _e20353 = (((((f32(_e20315.member) + 0.5f) / f32(_e14379)) * 2f) - 1f) * _e20352);
let _e20360 = global_1.member.member_2.member_1;
let _e20361 = ((1f - (((f32(_e20315.member_1) + 0.5f) / f32(_e14380)) * 2f)) * _e20360);
let _e20363 = global_1.member.member_3;
let _e20371 = global_1.member.member_4;
let _e20378 = ((_e20363.member * _e20353) + (_e20371.member * _e20361));
let _e20379 = ((_e20363.member_1 * _e20353) + (_e20371.member_1 * _e20361));
let _e20380 = ((_e20363.member_2 * _e20353) + (_e20371.member_2 * _e20361));
let _e20383 = global_1.member.member_2.member_3;
let _e20384 = (_e20383 != 0u);
let _e20386 = global_1.member.member_5;
let _e20393 = select((_e20386.member + _e20378), _e20386.member, _e20384);
let _e20394 = select((_e20386.member_1 + _e20379), _e20386.member_1, _e20384);
let _e20395 = select((_e20386.member_2 + _e20380), _e20386.member_2, _e20384);
let _e20397 = global_1.member.member_6;
let _e20411 = (((_e20393 * _e20393) + (_e20394 * _e20394)) + (_e20395 * _e20395));
let _e20414 = sqrt(select(0f, _e20411, (_e20411 > 0f)));
let _e20415 = (1f / _e20414);
let _e20416 = (_e20393 * _e20415);
let _e20417 = (_e20394 * _e20415);
let _e20418 = (_e20395 * _e20415);
let _e20419 = (_e574 - select(_e20397.member, (_e20397.member + _e20378), _e20384));
let _e20420 = (_e586 - select(_e20397.member_1, (_e20397.member_1 + _e20379), _e20384));
let _e20421 = (_e599 - select(_e20397.member_2, (_e20397.member_2 + _e20380), _e20384));
let _e20426 = (((_e20419 * _e20416) + (_e20420 * _e20417)) + (_e20421 * _e20418));
let _e20431 = (((_e20419 * _e612) + (_e20420 * _e625)) + (_e20421 * _e638));
let _e20436 = (((_e20416 * _e612) + (_e20417 * _e625)) + (_e20418 * _e638));
let _e20439 = ((_e20417 * _e638) - (_e20418 * _e625));
let _e20442 = ((_e20418 * _e612) - (_e20416 * _e638));
let _e20445 = ((_e20416 * _e625) - (_e20417 * _e612));
let _e20450 = (((_e20439 * _e20439) + (_e20442 * _e20442)) + (_e20445 * _e20445));
let _e20453 = (1f / select(1e-9f, _e20450, (_e20450 > 1e-9f)));
let _e20456 = ((_e20426 - (_e20436 * _e20431)) * _e20453);
let _e20459 = (((_e20436 * _e20426) - _e20431) * _e20453);
let _e20465 = -(_e20436);
let _e20468 = global_1.member.member_13.member_2;
let _e20469 = (_e20468 * _e20468);
let _e20473 = ((1f + _e20469) - ((2f * _e20468) * _e20465));
let _e20475 = select(1e-9f, _e20473, (_e20473 > 1e-9f));
let _e20487 = global_1.member.member_13.member_3;
let _e20492 = (_e20414 * (select(((1f - _e20469) / (_e20475 * sqrt(select(0f, _e20475, (_e20475 > 0f))))), (0.75f * (1f + (_e20465 * _e20465))), (_e20487 == 1u)) * (0.25f / 3.1415927f)));
let _e20493 = (_e20456 - _e20333);
let _e20496 = (_e20459 + select(0f, _e20493, (_e20493 > 0f)));
let _e20499 = global_1.member.member_13.member_1;
let _e20508 = global_1.member.member_13.member;
let _e20513 = -((_e20508.member * _e20496));
let _e20515 = select(-87f, _e20513, (_e20513 > -87f));
let _e20517 = select(88f, _e20515, (_e20515 < 88f));
let _e20519 = ((_e20517 * 1.442695f) + 0.5f);
let _e20521 = select(-127f, _e20519, (_e20519 > -127f));
let _e20523 = select(128f, _e20521, (_e20521 < 128f));
let _e20530 = select(0i, select(select(i32(_e20523), i32(-2147483648), (_e20523 < -2147483600f)), 2147483647i, (_e20523 > 2147483500f)), (_e20523 == _e20523));
let _e20534 = (_e20530 - select(0i, 1i, (_e20523 < f32(_e20530))));
let _e20535 = f32(_e20534);
let _e20539 = ((_e20517 - (_e20535 * 0.6933594f)) - (_e20535 * -2.1219444e-4f));
let _e20561 = -((_e20508.member_1 * _e20496));
let _e20563 = select(-87f, _e20561, (_e20561 > -87f));
let _e20565 = select(88f, _e20563, (_e20563 < 88f));
let _e20567 = ((_e20565 * 1.442695f) + 0.5f);
let _e20569 = select(-127f, _e20567, (_e20567 > -127f));
let _e20571 = select(128f, _e20569, (_e20569 < 128f));
let _e20578 = select(0i, select(select(i32(_e20571), i32(-2147483648), (_e20571 < -2147483600f)), 2147483647i, (_e20571 > 2147483500f)), (_e20571 == _e20571));
let _e20582 = (_e20578 - select(0i, 1i, (_e20571 < f32(_e20578))));
let _e20583 = f32(_e20582);
let _e20587 = ((_e20565 - (_e20583 * 0.6933594f)) - (_e20583 * -2.1219444e-4f));
let _e20609 = -((_e20508.member_2 * _e20496));
let _e20611 = select(-87f, _e20609, (_e20609 > -87f));
let _e20613 = select(88f, _e20611, (_e20611 < 88f));
let _e20615 = ((_e20613 * 1.442695f) + 0.5f);
let _e20617 = select(-127f, _e20615, (_e20615 > -127f));
let _e20619 = select(128f, _e20617, (_e20617 < 128f));
let _e20626 = select(0i, select(select(i32(_e20619), i32(-2147483648), (_e20619 < -2147483600f)), 2147483647i, (_e20619 > 2147483500f)), (_e20619 == _e20619));
let _e20630 = (_e20626 - select(0i, 1i, (_e20619 < f32(_e20626))));
let _e20631 = f32(_e20630);
let _e20635 = ((_e20613 - (_e20631 * 0.6933594f)) - (_e20631 * -2.1219444e-4f));
let _e20662 = select(0f, _e20456, (((_e20459 >= 0f) && (_e20459 < _e690)) && (_e20456 > 0f)));
if _e452 {
phi_52569_ = type_23(_e20261, _e20168);
} else {
phi_52569_ = type_23(_e20168, _e20261);
}
let _e20673 = phi_52569_;
let _e20676 = (_e20262 && (((_e20662 > 0f) && (_e20662 < _e20341)) && true));
let _e20679 = global_1.member.member_18.member;
let _e20680 = (((select(_e20287, (1f - _e20287), (_e20272 >= 0f)) - select(_e20306, (1f - _e20306), (_e20291 >= 0f))) * (1f / _e20269)) * _e20679);
let _e20684 = select(0f, (((((_e651 * _e20499.member) * ((1f + (_e20539 * (1f + (_e20539 * (0.5f + (_e20539 * (0.16666667f + (_e20539 * (0.041666668f + (_e20539 * (0.008333334f + (_e20539 * (0.001388889f + (_e20539 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20534 + 127i)) << bitcast<u32>(23i))))) * _e20492) * 1f) * _e20680), _e20676);
let _e20685 = select(0f, (((((_e664 * _e20499.member_1) * ((1f + (_e20587 * (1f + (_e20587 * (0.5f + (_e20587 * (0.16666667f + (_e20587 * (0.041666668f + (_e20587 * (0.008333334f + (_e20587 * (0.001388889f + (_e20587 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20582 + 127i)) << bitcast<u32>(23i))))) * _e20492) * 1f) * _e20680), _e20676);
let _e20686 = select(0f, (((((_e677 * _e20499.member_2) * ((1f + (_e20635 * (1f + (_e20635 * (0.5f + (_e20635 * (0.16666667f + (_e20635 * (0.041666668f + (_e20635 * (0.008333334f + (_e20635 * (0.001388889f + (_e20635 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e20630 + 127i)) << bitcast<u32>(23i))))) * _e20492) * 1f) * _e20680), _e20676);
let _e20690 = (bitcast<f32>((bitcast<u32>(_e20684) & 2147483647u)) >= 1073741800f);
let _e20691 = (1f / 1048576f);
let _e20694 = ((_e20684 * select(1f, _e20691, _e20690)) + 0.5f);
let _e20696 = select(-1073741800f, _e20694, (_e20694 > -1073741800f));
let _e20698 = select(1073741800f, _e20696, (_e20696 < 1073741800f));
let _e20705 = select(0i, select(select(i32(_e20698), i32(-2147483648), (_e20698 < -2147483600f)), 2147483647i, (_e20698 > 2147483500f)), (_e20698 == _e20698));
let _e20709 = (_e20705 - select(0i, 1i, (_e20698 < f32(_e20705))));
let _e20710 = select(0i, 20i, _e20690);
let _e20714 = (bitcast<u32>(_e20709) << bitcast<u32>((_e20710 & 31i)));
let _e20721 = bitcast<u32>(((_e20709 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20710) & 31i))));
let _e20725 = (bitcast<f32>((bitcast<u32>(_e20685) & 2147483647u)) >= 1073741800f);
let _e20728 = ((_e20685 * select(1f, _e20691, _e20725)) + 0.5f);
let _e20730 = select(-1073741800f, _e20728, (_e20728 > -1073741800f));
let _e20732 = select(1073741800f, _e20730, (_e20730 < 1073741800f));
let _e20739 = select(0i, select(select(i32(_e20732), i32(-2147483648), (_e20732 < -2147483600f)), 2147483647i, (_e20732 > 2147483500f)), (_e20732 == _e20732));
let _e20743 = (_e20739 - select(0i, 1i, (_e20732 < f32(_e20739))));
let _e20744 = select(0i, 20i, _e20725);
let _e20748 = (bitcast<u32>(_e20743) << bitcast<u32>((_e20744 & 31i)));
let _e20755 = bitcast<u32>(((_e20743 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20744) & 31i))));
let _e20759 = (bitcast<f32>((bitcast<u32>(_e20686) & 2147483647u)) >= 1073741800f);
let _e20762 = ((_e20686 * select(1f, _e20691, _e20759)) + 0.5f);
let _e20764 = select(-1073741800f, _e20762, (_e20762 > -1073741800f));
let _e20766 = select(1073741800f, _e20764, (_e20764 < 1073741800f));
let _e20773 = select(0i, select(select(i32(_e20766), i32(-2147483648), (_e20766 < -2147483600f)), 2147483647i, (_e20766 > 2147483500f)), (_e20766 == _e20766));
let _e20777 = (_e20773 - select(0i, 1i, (_e20766 < f32(_e20773))));
let _e20778 = select(0i, 20i, _e20759);
let _e20782 = (bitcast<u32>(_e20777) << bitcast<u32>((_e20778 & 31i)));
let _e20789 = bitcast<u32>(((_e20777 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e20778) & 31i))));
let _e20794 = bitcast<i32>(bitcast<u32>((((_e20673.member_1 * _e14379) + _e20673.member) * 6i)));
if ((_e20714 | _e20721) == 0u) {
} else {
let _e20797 = bitcast<u32>(_e20794);
if (_e20797 < _e269) {
let _e20801 = atomicAdd((&global_8.member[_e20797]), _e20714);
phi_52802_ = _e20801;
} else {
phi_52802_ = 0u;
}
let _e20803 = phi_52802_;
let _e20807 = (_e20721 + select(0u, 1u, ((_e20803 + _e20714) < _e20714)));
if (_e20807 == 0u) {
} else {
let _e20809 = (_e20797 + 1u);
if (_e20809 < _e269) {
let _e20813 = atomicAdd((&global_8.member[_e20809]), _e20807);
}
}
}
if ((_e20748 | _e20755) == 0u) {
} else {
let _e20817 = bitcast<u32>((_e20794 + 2i));
if (_e20817 < _e269) {
let _e20821 = atomicAdd((&global_8.member[_e20817]), _e20748);
phi_52832_ = _e20821;
} else {
phi_52832_ = 0u;
}
let _e20823 = phi_52832_;
let _e20827 = (_e20755 + select(0u, 1u, ((_e20823 + _e20748) < _e20748)));
if (_e20827 == 0u) {
} else {
let _e20829 = (_e20817 + 1u);
if (_e20829 < _e269) {
let _e20833 = atomicAdd((&global_8.member[_e20829]), _e20827);
}
}
}
if ((_e20782 | _e20789) == 0u) {
} else {
let _e20837 = bitcast<u32>((_e20794 + 4i));
if (_e20837 < _e269) {
let _e20841 = atomicAdd((&global_8.member[_e20837]), _e20782);
phi_52862_ = _e20841;
} else {
phi_52862_ = 0u;
}
let _e20843 = phi_52862_;
let _e20847 = (_e20789 + select(0u, 1u, ((_e20843 + _e20782) < _e20782)));
if (_e20847 == 0u) {
} else {
let _e20849 = (_e20837 + 1u);
if (_e20849 < _e269) {
let _e20853 = atomicAdd((&global_8.member[_e20849]), _e20847);
}
}
}
phi_51913_ = (_e20259 + 1i);
} else {
phi_51913_ = i32();
}
let _e20856 = phi_51913_;
continue;
continuing {
phi_51912_ = _e20856;
break if !(_e20262);
}
}
phi_51759_ = (_e20165 + 1i);
} else {
phi_51759_ = i32();
}
let _e20860 = phi_51759_;
continue;
continuing {
phi_51758_ = _e20860;
break if !(_e20166);
}
}
} else {
if (_e20162 == 1u) {
phi_52911_ = 0i;
loop {
let _e20864 = phi_52911_;
let _e20865 = (_e20864 < 16i);
if _e20865 {
let _e20867 = (_e14424 + (_e20864 & 15i));
let _e20869 = (f32(_e20867) + 0.5f);
let _e20871 = ((_e20869 * 1f) - 0.5f);
let _e20875 = (-(((_e415 * _e20871) + _e441)) / _e428);
let _e20882 = bitcast<f32>((bitcast<u32>(((_e465 * _e20871) + ((_e478 * _e20875) + _e491))) & 2147483647u));
let _e20889 = bitcast<f32>((bitcast<u32>(((_e504 * _e20871) + ((_e517 * _e20875) + _e530))) & 2147483647u));
let _e20893 = (((0.5f * (_e20882 + _e20889)) / _e533) + _e716);
let _e20894 = (1f / 1f);
let _e20902 = ((((_e20875 + _e20893) + 0.5f) * _e20894) - 0.5f);
let _e20903 = f32(_e20148);
let _e20904 = f32(_e20146);
let _e20905 = (_e20903 - 1f);
let _e20907 = select(_e20905, _e20902, (_e20902 > _e20905));
let _e20909 = select(_e20904, _e20907, (_e20907 < _e20904));
let _e20916 = select(0i, select(select(i32(_e20909), i32(-2147483648), (_e20909 < -2147483600f)), 2147483647i, (_e20909 > 2147483500f)), (_e20909 == _e20909));
let _e20921 = (((((_e20875 - _e20893) + 0.5f) * _e20894) - 0.5f) + 1f);
let _e20922 = (_e20904 + 1f);
let _e20924 = select(_e20903, _e20921, (_e20921 > _e20903));
let _e20926 = select(_e20922, _e20924, (_e20924 < _e20922));
let _e20933 = select(0i, select(select(i32(_e20926), i32(-2147483648), (_e20926 < -2147483600f)), 2147483647i, (_e20926 > 2147483500f)), (_e20926 == _e20926));
let _e20944 = ((1e-4f * 1f) * _e533);
let _e20946 = select(_e20889, _e20882, (_e20882 > _e20889));
let _e20948 = select(_e20944, _e20946, (_e20946 > _e20944));
let _e20950 = select(_e20889, _e20882, (_e20882 < _e20889));
let _e20952 = select(_e20944, _e20950, (_e20950 > _e20944));
let _e20954 = (0.5f * (_e20948 + _e20952));
let _e20955 = (0.5f / _e20952);
let _e20956 = (1f / _e20948);
phi_53065_ = 0i;
loop {
let _e20958 = phi_53065_;
let _e20960 = (((_e20933 - select(0i, 1i, (_e20926 < f32(_e20933)))) + (_e20864 >> bitcast<u32>(4u))) + bitcast<i32>(_e20958));
let _e20961 = (_e20960 <= select(-1i, (_e20916 - select(0i, 1i, (_e20909 < f32(_e20916)))), (_e20867 <= _e14428)));
if _e20961 {
let _e20963 = (f32(_e20960) + 0.5f);
let _e20967 = ((((_e20963 * 1f) - 0.5f) - _e20875) * _e533);
let _e20968 = (_e533 * 1f);
let _e20970 = (0.5f * _e20968);
let _e20971 = (_e20967 + _e20970);
let _e20972 = -(_e20971);
let _e20975 = (_e20954 - select(_e20972, _e20971, (_e20971 > _e20972)));
let _e20977 = select(0f, _e20975, (_e20975 > 0f));
let _e20979 = select(_e20952, _e20977, (_e20977 < _e20952));
let _e20982 = (_e20975 - _e20952);
let _e20986 = (((_e20979 * (_e20979 * _e20955)) + select(0f, _e20982, (_e20982 > 0f))) * _e20956);
let _e20990 = (_e20967 - _e20970);
let _e20991 = -(_e20990);
let _e20994 = (_e20954 - select(_e20991, _e20990, (_e20990 > _e20991)));
let _e20996 = select(0f, _e20994, (_e20994 > 0f));
let _e20998 = select(_e20952, _e20996, (_e20996 < _e20952));
let _e21001 = (_e20994 - _e20952);
let _e21005 = (((_e20998 * (_e20998 * _e20955)) + select(0f, _e21001, (_e21001 > 0f))) * _e20956);
if _e452 {
phi_53170_ = type_23(_e20960, _e20867);
} else {
phi_53170_ = type_23(_e20867, _e20960);
}
let _e21014 = phi_53170_;
local_34 = bitcast<i32>((_e14375 * _e14378));
local_35 = ((_e21014.member_1 * _e14379) + _e21014.member);
let _e21021 = local_34;
let _e21022 = local_35;
let _e21023 = (_e21021 + _e21022);
let _e21025 = (bitcast<i32>(_e258) - 1i);
let _e21027 = select(_e21025, _e21023, (_e21023 < _e21025));
let _e21032 = global_5.member[bitcast<u32>(select(0i, _e21027, (_e21027 > 0i)))];
let _e21033 = local_35;
let _e21035 = select(_e21025, _e21033, (_e21033 < _e21025));
let _e21040 = global_5.member[bitcast<u32>(select(0i, _e21035, (_e21035 > 0i)))];
let _e21043 = f32(_e14379);
let _e21044 = f32(_e14380);
let _e21051 = global_1.member.member_2.member;
let _e21052 = (((((f32(_e21014.member) + 0.5f) / _e21043) * 2f) - 1f) * _e21051);
let _e21059 = global_1.member.member_2.member_1;
let _e21060 = ((1f - (((f32(_e21014.member_1) + 0.5f) / _e21044) * 2f)) * _e21059);
let _e21062 = global_1.member.member_3;
let _e21070 = global_1.member.member_4;
let _e21077 = ((_e21062.member * _e21052) + (_e21070.member * _e21060));
let _e21078 = ((_e21062.member_1 * _e21052) + (_e21070.member_1 * _e21060));
let _e21079 = ((_e21062.member_2 * _e21052) + (_e21070.member_2 * _e21060));
let _e21082 = global_1.member.member_2.member_3;
let _e21083 = (_e21082 != 0u);
let _e21085 = global_1.member.member_5;
let _e21092 = select((_e21085.member + _e21077), _e21085.member, _e21083);
let _e21093 = select((_e21085.member_1 + _e21078), _e21085.member_1, _e21083);
let _e21094 = select((_e21085.member_2 + _e21079), _e21085.member_2, _e21083);
let _e21096 = global_1.member.member_6;
let _e21110 = (((_e21092 * _e21092) + (_e21093 * _e21093)) + (_e21094 * _e21094));
let _e21113 = sqrt(select(0f, _e21110, (_e21110 > 0f)));
let _e21114 = (1f / _e21113);
let _e21115 = (_e21092 * _e21114);
let _e21116 = (_e21093 * _e21114);
let _e21117 = (_e21094 * _e21114);
let _e21118 = (_e574 - select(_e21096.member, (_e21096.member + _e21077), _e21083));
let _e21119 = (_e586 - select(_e21096.member_1, (_e21096.member_1 + _e21078), _e21083));
let _e21120 = (_e599 - select(_e21096.member_2, (_e21096.member_2 + _e21079), _e21083));
let _e21125 = (((_e21118 * _e21115) + (_e21119 * _e21116)) + (_e21120 * _e21117));
let _e21130 = (((_e21118 * _e612) + (_e21119 * _e625)) + (_e21120 * _e638));
let _e21135 = (((_e21115 * _e612) + (_e21116 * _e625)) + (_e21117 * _e638));
let _e21138 = ((_e21116 * _e638) - (_e21117 * _e625));
let _e21141 = ((_e21117 * _e612) - (_e21115 * _e638));
let _e21144 = ((_e21115 * _e625) - (_e21116 * _e612));
let _e21149 = (((_e21138 * _e21138) + (_e21141 * _e21141)) + (_e21144 * _e21144));
let _e21152 = (1f / select(1e-9f, _e21149, (_e21149 > 1e-9f)));
let _e21155 = ((_e21125 - (_e21135 * _e21130)) * _e21152);
let _e21158 = (((_e21135 * _e21125) - _e21130) * _e21152);
let _e21164 = -(_e21135);
let _e21167 = global_1.member.member_13.member_2;
let _e21168 = (_e21167 * _e21167);
let _e21172 = ((1f + _e21168) - ((2f * _e21167) * _e21164));
let _e21174 = select(1e-9f, _e21172, (_e21172 > 1e-9f));
let _e21186 = global_1.member.member_13.member_3;
let _e21191 = (_e21113 * (select(((1f - _e21168) / (_e21174 * sqrt(select(0f, _e21174, (_e21174 > 0f))))), (0.75f * (1f + (_e21164 * _e21164))), (_e21186 == 1u)) * (0.25f / 3.1415927f)));
let _e21192 = (_e21155 - _e21032);
let _e21195 = (_e21158 + select(0f, _e21192, (_e21192 > 0f)));
let _e21198 = global_1.member.member_13.member_1;
let _e21207 = global_1.member.member_13.member;
let _e21212 = -((_e21207.member * _e21195));
let _e21214 = select(-87f, _e21212, (_e21212 > -87f));
let _e21216 = select(88f, _e21214, (_e21214 < 88f));
let _e21218 = ((_e21216 * 1.442695f) + 0.5f);
let _e21220 = select(-127f, _e21218, (_e21218 > -127f));
let _e21222 = select(128f, _e21220, (_e21220 < 128f));
let _e21229 = select(0i, select(select(i32(_e21222), i32(-2147483648), (_e21222 < -2147483600f)), 2147483647i, (_e21222 > 2147483500f)), (_e21222 == _e21222));
let _e21233 = (_e21229 - select(0i, 1i, (_e21222 < f32(_e21229))));
let _e21234 = f32(_e21233);
let _e21238 = ((_e21216 - (_e21234 * 0.6933594f)) - (_e21234 * -2.1219444e-4f));
let _e21260 = -((_e21207.member_1 * _e21195));
let _e21262 = select(-87f, _e21260, (_e21260 > -87f));
let _e21264 = select(88f, _e21262, (_e21262 < 88f));
let _e21266 = ((_e21264 * 1.442695f) + 0.5f);
let _e21268 = select(-127f, _e21266, (_e21266 > -127f));
let _e21270 = select(128f, _e21268, (_e21268 < 128f));
let _e21277 = select(0i, select(select(i32(_e21270), i32(-2147483648), (_e21270 < -2147483600f)), 2147483647i, (_e21270 > 2147483500f)), (_e21270 == _e21270));
let _e21281 = (_e21277 - select(0i, 1i, (_e21270 < f32(_e21277))));
let _e21282 = f32(_e21281);
let _e21286 = ((_e21264 - (_e21282 * 0.6933594f)) - (_e21282 * -2.1219444e-4f));
let _e21308 = -((_e21207.member_2 * _e21195));
let _e21310 = select(-87f, _e21308, (_e21308 > -87f));
let _e21312 = select(88f, _e21310, (_e21310 < 88f));
let _e21314 = ((_e21312 * 1.442695f) + 0.5f);
let _e21316 = select(-127f, _e21314, (_e21314 > -127f));
let _e21318 = select(128f, _e21316, (_e21316 < 128f));
let _e21325 = select(0i, select(select(i32(_e21318), i32(-2147483648), (_e21318 < -2147483600f)), 2147483647i, (_e21318 > 2147483500f)), (_e21318 == _e21318));
let _e21329 = (_e21325 - select(0i, 1i, (_e21318 < f32(_e21325))));
let _e21330 = f32(_e21329);
let _e21334 = ((_e21312 - (_e21330 * 0.6933594f)) - (_e21330 * -2.1219444e-4f));
let _e21361 = select(0f, _e21155, (((_e21158 >= 0f) && (_e21158 < _e690)) && (_e21155 > 0f)));
let _e21363 = ((_e765 + _e20150) + _e20154);
let _e21364 = (_e21363 & 31u);
let _e21366 = (1u << bitcast<u32>(_e21364));
let _e21375 = bitcast<i32>((((_e14375 + _e21366) - 1u) >> bitcast<u32>(_e21364)));
let _e21376 = bitcast<i32>((((_e14378 + _e21366) - 1u) >> bitcast<u32>(_e21364)));
if _e452 {
phi_53748_ = type_23(_e21376, _e21375);
} else {
phi_53748_ = type_23(_e21375, _e21376);
}
let _e21380 = phi_53748_;
let _e21385 = f32((1i << bitcast<u32>(_e21364)));
let _e21386 = (1f / _e21385);
let _e21388 = ((_e20869 * _e21386) - 0.5f);
let _e21390 = ((_e20963 * _e21386) - 0.5f);
let _e21392 = select(-1f, _e21388, (_e21388 > -1f));
let _e21394 = select(1e6f, _e21392, (_e21392 < 1e6f));
let _e21401 = select(0i, select(select(i32(_e21394), i32(-2147483648), (_e21394 < -2147483600f)), 2147483647i, (_e21394 > 2147483500f)), (_e21394 == _e21394));
let _e21405 = (_e21401 - select(0i, 1i, (_e21394 < f32(_e21401))));
let _e21407 = select(-1f, _e21390, (_e21390 > -1f));
let _e21409 = select(1e6f, _e21407, (_e21407 < 1e6f));
let _e21416 = select(0i, select(select(i32(_e21409), i32(-2147483648), (_e21409 < -2147483600f)), 2147483647i, (_e21409 > 2147483500f)), (_e21409 == _e21409));
let _e21420 = (_e21416 - select(0i, 1i, (_e21409 < f32(_e21416))));
let _e21422 = (_e21388 - f32(_e21405));
let _e21424 = (_e21390 - f32(_e21420));
let _e21425 = (1f - _e21422);
let _e21426 = (1f - _e21424);
let _e21429 = select(_e21405, 0i, (_e21405 < 0i));
let _e21430 = (_e21429 >= _e21380.member);
if _e21430 {
phi_53826_ = (_e21380.member - 1i);
} else {
phi_53826_ = _e21429;
}
let _e21433 = phi_53826_;
let _e21435 = select(_e21420, 0i, (_e21420 < 0i));
let _e21436 = (_e21435 >= _e21380.member_1);
if _e21436 {
phi_53837_ = (_e21380.member_1 - 1i);
} else {
phi_53837_ = _e21435;
}
let _e21439 = phi_53837_;
let _e21443 = (((f32(_e21433) + 0.5f) * _e21385) - 0.5f);
let _e21447 = (((f32(_e21439) + 0.5f) * _e21385) - 0.5f);
if _e452 {
phi_53865_ = type_23(_e21439, _e21433);
} else {
phi_53865_ = type_23(_e21433, _e21439);
}
let _e21453 = phi_53865_;
let _e21459 = bitcast<i32>(((_e14375 + 1u) >> bitcast<u32>(1u)));
let _e21462 = global_1.member.member_18.member_6;
let _e21465 = global_1.member.member_18.member_7;
let _e21468 = global_1.member.member_18.member_8;
let _e21469 = (_e21363 == 0u);
if _e21469 {
phi_53916_ = 0u;
} else {
if (_e21363 == 1u) {
phi_53915_ = 0u;
} else {
if (_e21363 == 2u) {
phi_53914_ = _e21462;
} else {
phi_53914_ = select(_e21468, _e21465, (_e21363 == 3u));
}
let _e21475 = phi_53914_;
phi_53915_ = _e21475;
}
let _e21477 = phi_53915_;
phi_53916_ = _e21477;
}
let _e21479 = phi_53916_;
local_32 = (((bitcast<i32>(_e21479) + _e21453.member_1) * _e21459) + _e21453.member);
let _e21484 = local_32;
let _e21486 = (bitcast<i32>(_e261) - 1i);
let _e21488 = select(_e21486, _e21484, (_e21484 < _e21486));
let _e21493 = global_6.member[bitcast<u32>(select(0i, _e21488, (_e21488 > 0i)))];
let _e21498 = (((((select(_e21443, _e21447, _e452) + 0.5f) / _e21043) * 2f) - 1f) * _e21051);
let _e21503 = ((1f - (((select(_e21447, _e21443, _e452) + 0.5f) / _e21044) * 2f)) * _e21059);
let _e21510 = ((_e21062.member * _e21498) + (_e21070.member * _e21503));
let _e21511 = ((_e21062.member_1 * _e21498) + (_e21070.member_1 * _e21503));
let _e21512 = ((_e21062.member_2 * _e21498) + (_e21070.member_2 * _e21503));
let _e21516 = select((_e21085.member + _e21510), _e21085.member, _e21083);
let _e21517 = select((_e21085.member_1 + _e21511), _e21085.member_1, _e21083);
let _e21518 = select((_e21085.member_2 + _e21512), _e21085.member_2, _e21083);
let _e21529 = (((_e21516 * _e21516) + (_e21517 * _e21517)) + (_e21518 * _e21518));
let _e21533 = (1f / sqrt(select(0f, _e21529, (_e21529 > 0f))));
let _e21534 = (_e21516 * _e21533);
let _e21535 = (_e21517 * _e21533);
let _e21536 = (_e21518 * _e21533);
let _e21537 = (_e574 - select(_e21096.member, (_e21096.member + _e21510), _e21083));
let _e21538 = (_e586 - select(_e21096.member_1, (_e21096.member_1 + _e21511), _e21083));
let _e21539 = (_e599 - select(_e21096.member_2, (_e21096.member_2 + _e21512), _e21083));
let _e21544 = (((_e21537 * _e21534) + (_e21538 * _e21535)) + (_e21539 * _e21536));
let _e21549 = (((_e21537 * _e612) + (_e21538 * _e625)) + (_e21539 * _e638));
let _e21554 = (((_e21534 * _e612) + (_e21535 * _e625)) + (_e21536 * _e638));
let _e21557 = ((_e21535 * _e638) - (_e21536 * _e625));
let _e21560 = ((_e21536 * _e612) - (_e21534 * _e638));
let _e21563 = ((_e21534 * _e625) - (_e21535 * _e612));
let _e21568 = (((_e21557 * _e21557) + (_e21560 * _e21560)) + (_e21563 * _e21563));
let _e21571 = (1f / select(1e-9f, _e21568, (_e21568 > 1e-9f)));
let _e21574 = ((_e21544 - (_e21554 * _e21549)) * _e21571);
let _e21577 = (((_e21554 * _e21544) - _e21549) * _e21571);
let _e21583 = select(0f, _e21574, (((_e21577 >= 0f) && (_e21577 < _e690)) && (_e21574 > 0f)));
let _e21585 = (_e21433 << bitcast<u32>(_e21364));
let _e21597 = (_e21405 + 1i);
let _e21600 = select(_e21597, 0i, (_e21597 < 0i));
let _e21601 = (_e21600 >= _e21380.member);
if _e21601 {
phi_54463_ = (_e21380.member - 1i);
} else {
phi_54463_ = _e21600;
}
let _e21604 = phi_54463_;
if _e21436 {
phi_54474_ = (_e21380.member_1 - 1i);
} else {
phi_54474_ = _e21435;
}
let _e21607 = phi_54474_;
let _e21611 = (((f32(_e21604) + 0.5f) * _e21385) - 0.5f);
let _e21615 = (((f32(_e21607) + 0.5f) * _e21385) - 0.5f);
if _e452 {
phi_54502_ = type_23(_e21607, _e21604);
} else {
phi_54502_ = type_23(_e21604, _e21607);
}
let _e21621 = phi_54502_;
if _e21469 {
phi_54553_ = 0u;
} else {
if (_e21363 == 1u) {
phi_54552_ = 0u;
} else {
if (_e21363 == 2u) {
phi_54551_ = _e21462;
} else {
phi_54551_ = select(_e21468, _e21465, (_e21363 == 3u));
}
let _e21629 = phi_54551_;
phi_54552_ = _e21629;
}
let _e21631 = phi_54552_;
phi_54553_ = _e21631;
}
let _e21633 = phi_54553_;
local_30 = (((bitcast<i32>(_e21633) + _e21621.member_1) * _e21459) + _e21621.member);
let _e21638 = local_30;
let _e21640 = select(_e21486, _e21638, (_e21638 < _e21486));
let _e21645 = global_6.member[bitcast<u32>(select(0i, _e21640, (_e21640 > 0i)))];
let _e21650 = (((((select(_e21611, _e21615, _e452) + 0.5f) / _e21043) * 2f) - 1f) * _e21051);
let _e21655 = ((1f - (((select(_e21615, _e21611, _e452) + 0.5f) / _e21044) * 2f)) * _e21059);
let _e21662 = ((_e21062.member * _e21650) + (_e21070.member * _e21655));
let _e21663 = ((_e21062.member_1 * _e21650) + (_e21070.member_1 * _e21655));
let _e21664 = ((_e21062.member_2 * _e21650) + (_e21070.member_2 * _e21655));
let _e21668 = select((_e21085.member + _e21662), _e21085.member, _e21083);
let _e21669 = select((_e21085.member_1 + _e21663), _e21085.member_1, _e21083);
let _e21670 = select((_e21085.member_2 + _e21664), _e21085.member_2, _e21083);
let _e21681 = (((_e21668 * _e21668) + (_e21669 * _e21669)) + (_e21670 * _e21670));
let _e21685 = (1f / sqrt(select(0f, _e21681, (_e21681 > 0f))));
let _e21686 = (_e21668 * _e21685);
let _e21687 = (_e21669 * _e21685);
let _e21688 = (_e21670 * _e21685);
let _e21689 = (_e574 - select(_e21096.member, (_e21096.member + _e21662), _e21083));
let _e21690 = (_e586 - select(_e21096.member_1, (_e21096.member_1 + _e21663), _e21083));
let _e21691 = (_e599 - select(_e21096.member_2, (_e21096.member_2 + _e21664), _e21083));
let _e21696 = (((_e21689 * _e21686) + (_e21690 * _e21687)) + (_e21691 * _e21688));
let _e21701 = (((_e21689 * _e612) + (_e21690 * _e625)) + (_e21691 * _e638));
let _e21706 = (((_e21686 * _e612) + (_e21687 * _e625)) + (_e21688 * _e638));
let _e21709 = ((_e21687 * _e638) - (_e21688 * _e625));
let _e21712 = ((_e21688 * _e612) - (_e21686 * _e638));
let _e21715 = ((_e21686 * _e625) - (_e21687 * _e612));
let _e21720 = (((_e21709 * _e21709) + (_e21712 * _e21712)) + (_e21715 * _e21715));
let _e21723 = (1f / select(1e-9f, _e21720, (_e21720 > 1e-9f)));
let _e21726 = ((_e21696 - (_e21706 * _e21701)) * _e21723);
let _e21729 = (((_e21706 * _e21696) - _e21701) * _e21723);
let _e21735 = select(0f, _e21726, (((_e21729 >= 0f) && (_e21729 < _e690)) && (_e21726 > 0f)));
let _e21737 = (_e21604 << bitcast<u32>(_e21364));
let _e21749 = (_e21420 + 1i);
if _e21430 {
phi_55100_ = (_e21380.member - 1i);
} else {
phi_55100_ = _e21429;
}
let _e21753 = phi_55100_;
let _e21755 = select(_e21749, 0i, (_e21749 < 0i));
let _e21756 = (_e21755 >= _e21380.member_1);
if _e21756 {
phi_55111_ = (_e21380.member_1 - 1i);
} else {
phi_55111_ = _e21755;
}
let _e21759 = phi_55111_;
let _e21763 = (((f32(_e21753) + 0.5f) * _e21385) - 0.5f);
let _e21767 = (((f32(_e21759) + 0.5f) * _e21385) - 0.5f);
if _e452 {
phi_55139_ = type_23(_e21759, _e21753);
} else {
phi_55139_ = type_23(_e21753, _e21759);
}
let _e21773 = phi_55139_;
if _e21469 {
phi_55190_ = 0u;
} else {
if (_e21363 == 1u) {
phi_55189_ = 0u;
} else {
if (_e21363 == 2u) {
phi_55188_ = _e21462;
} else {
phi_55188_ = select(_e21468, _e21465, (_e21363 == 3u));
}
let _e21781 = phi_55188_;
phi_55189_ = _e21781;
}
let _e21783 = phi_55189_;
phi_55190_ = _e21783;
}
let _e21785 = phi_55190_;
local_28 = (((bitcast<i32>(_e21785) + _e21773.member_1) * _e21459) + _e21773.member);
let _e21790 = local_28;
let _e21792 = select(_e21486, _e21790, (_e21790 < _e21486));
let _e21797 = global_6.member[bitcast<u32>(select(0i, _e21792, (_e21792 > 0i)))];
let _e21802 = (((((select(_e21763, _e21767, _e452) + 0.5f) / _e21043) * 2f) - 1f) * _e21051);
let _e21807 = ((1f - (((select(_e21767, _e21763, _e452) + 0.5f) / _e21044) * 2f)) * _e21059);
let _e21814 = ((_e21062.member * _e21802) + (_e21070.member * _e21807));
let _e21815 = ((_e21062.member_1 * _e21802) + (_e21070.member_1 * _e21807));
let _e21816 = ((_e21062.member_2 * _e21802) + (_e21070.member_2 * _e21807));
let _e21820 = select((_e21085.member + _e21814), _e21085.member, _e21083);
let _e21821 = select((_e21085.member_1 + _e21815), _e21085.member_1, _e21083);
let _e21822 = select((_e21085.member_2 + _e21816), _e21085.member_2, _e21083);
let _e21833 = (((_e21820 * _e21820) + (_e21821 * _e21821)) + (_e21822 * _e21822));
let _e21837 = (1f / sqrt(select(0f, _e21833, (_e21833 > 0f))));
let _e21838 = (_e21820 * _e21837);
let _e21839 = (_e21821 * _e21837);
let _e21840 = (_e21822 * _e21837);
let _e21841 = (_e574 - select(_e21096.member, (_e21096.member + _e21814), _e21083));
let _e21842 = (_e586 - select(_e21096.member_1, (_e21096.member_1 + _e21815), _e21083));
let _e21843 = (_e599 - select(_e21096.member_2, (_e21096.member_2 + _e21816), _e21083));
let _e21848 = (((_e21841 * _e21838) + (_e21842 * _e21839)) + (_e21843 * _e21840));
let _e21853 = (((_e21841 * _e612) + (_e21842 * _e625)) + (_e21843 * _e638));
let _e21858 = (((_e21838 * _e612) + (_e21839 * _e625)) + (_e21840 * _e638));
let _e21861 = ((_e21839 * _e638) - (_e21840 * _e625));
let _e21864 = ((_e21840 * _e612) - (_e21838 * _e638));
let _e21867 = ((_e21838 * _e625) - (_e21839 * _e612));
let _e21872 = (((_e21861 * _e21861) + (_e21864 * _e21864)) + (_e21867 * _e21867));
let _e21875 = (1f / select(1e-9f, _e21872, (_e21872 > 1e-9f)));
let _e21878 = ((_e21848 - (_e21858 * _e21853)) * _e21875);
let _e21881 = (((_e21858 * _e21848) - _e21853) * _e21875);
let _e21887 = select(0f, _e21878, (((_e21881 >= 0f) && (_e21881 < _e690)) && (_e21878 > 0f)));
let _e21889 = (_e21753 << bitcast<u32>(_e21364));
if _e21601 {
phi_55737_ = (_e21380.member - 1i);
} else {
phi_55737_ = _e21600;
}
let _e21904 = phi_55737_;
if _e21756 {
phi_55748_ = (_e21380.member_1 - 1i);
} else {
phi_55748_ = _e21755;
}
let _e21907 = phi_55748_;
let _e21911 = (((f32(_e21904) + 0.5f) * _e21385) - 0.5f);
let _e21915 = (((f32(_e21907) + 0.5f) * _e21385) - 0.5f);
if _e452 {
phi_55776_ = type_23(_e21907, _e21904);
} else {
phi_55776_ = type_23(_e21904, _e21907);
}
let _e21921 = phi_55776_;
if _e21469 {
phi_55827_ = 0u;
} else {
if (_e21363 == 1u) {
phi_55826_ = 0u;
} else {
if (_e21363 == 2u) {
phi_55825_ = _e21462;
} else {
phi_55825_ = select(_e21468, _e21465, (_e21363 == 3u));
}
let _e21929 = phi_55825_;
phi_55826_ = _e21929;
}
let _e21931 = phi_55826_;
phi_55827_ = _e21931;
}
let _e21933 = phi_55827_;
local_26 = (((bitcast<i32>(_e21933) + _e21921.member_1) * _e21459) + _e21921.member);
let _e21938 = local_26;
let _e21940 = select(_e21486, _e21938, (_e21938 < _e21486));
let _e21945 = global_6.member[bitcast<u32>(select(0i, _e21940, (_e21940 > 0i)))];
let _e21950 = (((((select(_e21911, _e21915, _e452) + 0.5f) / _e21043) * 2f) - 1f) * _e21051);
let _e21955 = ((1f - (((select(_e21915, _e21911, _e452) + 0.5f) / _e21044) * 2f)) * _e21059);
let _e21962 = ((_e21062.member * _e21950) + (_e21070.member * _e21955));
let _e21963 = ((_e21062.member_1 * _e21950) + (_e21070.member_1 * _e21955));
let _e21964 = ((_e21062.member_2 * _e21950) + (_e21070.member_2 * _e21955));
let _e21968 = select((_e21085.member + _e21962), _e21085.member, _e21083);
let _e21969 = select((_e21085.member_1 + _e21963), _e21085.member_1, _e21083);
let _e21970 = select((_e21085.member_2 + _e21964), _e21085.member_2, _e21083);
let _e21981 = (((_e21968 * _e21968) + (_e21969 * _e21969)) + (_e21970 * _e21970));
let _e21985 = (1f / sqrt(select(0f, _e21981, (_e21981 > 0f))));
let _e21986 = (_e21968 * _e21985);
let _e21987 = (_e21969 * _e21985);
let _e21988 = (_e21970 * _e21985);
let _e21989 = (_e574 - select(_e21096.member, (_e21096.member + _e21962), _e21083));
let _e21990 = (_e586 - select(_e21096.member_1, (_e21096.member_1 + _e21963), _e21083));
let _e21991 = (_e599 - select(_e21096.member_2, (_e21096.member_2 + _e21964), _e21083));
let _e21996 = (((_e21989 * _e21986) + (_e21990 * _e21987)) + (_e21991 * _e21988));
let _e22001 = (((_e21989 * _e612) + (_e21990 * _e625)) + (_e21991 * _e638));
let _e22006 = (((_e21986 * _e612) + (_e21987 * _e625)) + (_e21988 * _e638));
let _e22009 = ((_e21987 * _e638) - (_e21988 * _e625));
let _e22012 = ((_e21988 * _e612) - (_e21986 * _e638));
let _e22015 = ((_e21986 * _e625) - (_e21987 * _e612));
let _e22020 = (((_e22009 * _e22009) + (_e22012 * _e22012)) + (_e22015 * _e22015));
let _e22023 = (1f / select(1e-9f, _e22020, (_e22020 > 1e-9f)));
let _e22026 = ((_e21996 - (_e22006 * _e22001)) * _e22023);
let _e22029 = (((_e22006 * _e21996) - _e22001) * _e22023);
let _e22035 = select(0f, _e22026, (((_e22029 >= 0f) && (_e22029 < _e690)) && (_e22026 > 0f)));
let _e22037 = (_e21904 << bitcast<u32>(_e21364));
let _e22049 = select(((((1f - select(0f, (_e21425 * _e21426), (((select(select(_e765, _e926, (_e21585 >= _e691)), _e846, (_e21585 < _e297)) == _e21363) && (_e21583 > 0f)) && (_e21583 < _e21493)))) - select(0f, (_e21422 * _e21426), (((select(select(_e765, _e926, (_e21737 >= _e691)), _e846, (_e21737 < _e297)) == _e21363) && (_e21735 > 0f)) && (_e21735 < _e21645)))) - select(0f, (_e21425 * _e21424), (((select(select(_e765, _e926, (_e21889 >= _e691)), _e846, (_e21889 < _e297)) == _e21363) && (_e21887 > 0f)) && (_e21887 < _e21797)))) - select(0f, (_e21422 * _e21424), (((select(select(_e765, _e926, (_e22037 >= _e691)), _e846, (_e22037 < _e297)) == _e21363) && (_e22035 > 0f)) && (_e22035 < _e21945)))), 1f, _e21469);
if _e452 {
phi_56383_ = type_23(_e20960, _e20867);
} else {
phi_56383_ = type_23(_e20867, _e20960);
}
let _e22064 = phi_56383_;
let _e22067 = (_e20961 && (((_e21361 > 0f) && (_e21361 < _e21040)) && (bitcast<f32>((bitcast<u32>(_e22049) & 2147483647u)) > 1e-6f)));
let _e22070 = global_1.member.member_18.member;
let _e22071 = (((select(_e20986, (1f - _e20986), (_e20971 >= 0f)) - select(_e21005, (1f - _e21005), (_e20990 >= 0f))) * (1f / _e20968)) * _e22070);
let _e22075 = select(0f, (((((_e651 * _e21198.member) * ((1f + (_e21238 * (1f + (_e21238 * (0.5f + (_e21238 * (0.16666667f + (_e21238 * (0.041666668f + (_e21238 * (0.008333334f + (_e21238 * (0.001388889f + (_e21238 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21233 + 127i)) << bitcast<u32>(23i))))) * _e21191) * _e22049) * _e22071), _e22067);
let _e22076 = select(0f, (((((_e664 * _e21198.member_1) * ((1f + (_e21286 * (1f + (_e21286 * (0.5f + (_e21286 * (0.16666667f + (_e21286 * (0.041666668f + (_e21286 * (0.008333334f + (_e21286 * (0.001388889f + (_e21286 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21281 + 127i)) << bitcast<u32>(23i))))) * _e21191) * _e22049) * _e22071), _e22067);
let _e22077 = select(0f, (((((_e677 * _e21198.member_2) * ((1f + (_e21334 * (1f + (_e21334 * (0.5f + (_e21334 * (0.16666667f + (_e21334 * (0.041666668f + (_e21334 * (0.008333334f + (_e21334 * (0.001388889f + (_e21334 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e21329 + 127i)) << bitcast<u32>(23i))))) * _e21191) * _e22049) * _e22071), _e22067);
let _e22081 = (bitcast<f32>((bitcast<u32>(_e22075) & 2147483647u)) >= 1073741800f);
let _e22082 = (1f / 1048576f);
let _e22085 = ((_e22075 * select(1f, _e22082, _e22081)) + 0.5f);
let _e22087 = select(-1073741800f, _e22085, (_e22085 > -1073741800f));
let _e22089 = select(1073741800f, _e22087, (_e22087 < 1073741800f));
let _e22096 = select(0i, select(select(i32(_e22089), i32(-2147483648), (_e22089 < -2147483600f)), 2147483647i, (_e22089 > 2147483500f)), (_e22089 == _e22089));
let _e22100 = (_e22096 - select(0i, 1i, (_e22089 < f32(_e22096))));
let _e22101 = select(0i, 20i, _e22081);
let _e22105 = (bitcast<u32>(_e22100) << bitcast<u32>((_e22101 & 31i)));
let _e22112 = bitcast<u32>(((_e22100 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22101) & 31i))));
let _e22116 = (bitcast<f32>((bitcast<u32>(_e22076) & 2147483647u)) >= 1073741800f);
let _e22119 = ((_e22076 * select(1f, _e22082, _e22116)) + 0.5f);
let _e22121 = select(-1073741800f, _e22119, (_e22119 > -1073741800f));
let _e22123 = select(1073741800f, _e22121, (_e22121 < 1073741800f));
let _e22130 = select(0i, select(select(i32(_e22123), i32(-2147483648), (_e22123 < -2147483600f)), 2147483647i, (_e22123 > 2147483500f)), (_e22123 == _e22123));
let _e22134 = (_e22130 - select(0i, 1i, (_e22123 < f32(_e22130))));
let _e22135 = select(0i, 20i, _e22116);
let _e22139 = (bitcast<u32>(_e22134) << bitcast<u32>((_e22135 & 31i)));
let _e22146 = bitcast<u32>(((_e22134 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22135) & 31i))));
let _e22150 = (bitcast<f32>((bitcast<u32>(_e22077) & 2147483647u)) >= 1073741800f);
let _e22153 = ((_e22077 * select(1f, _e22082, _e22150)) + 0.5f);
let _e22155 = select(-1073741800f, _e22153, (_e22153 > -1073741800f));
let _e22157 = select(1073741800f, _e22155, (_e22155 < 1073741800f));
let _e22164 = select(0i, select(select(i32(_e22157), i32(-2147483648), (_e22157 < -2147483600f)), 2147483647i, (_e22157 > 2147483500f)), (_e22157 == _e22157));
let _e22168 = (_e22164 - select(0i, 1i, (_e22157 < f32(_e22164))));
let _e22169 = select(0i, 20i, _e22150);
let _e22173 = (bitcast<u32>(_e22168) << bitcast<u32>((_e22169 & 31i)));
let _e22180 = bitcast<u32>(((_e22168 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e22169) & 31i))));
let _e22185 = bitcast<i32>(bitcast<u32>((((_e22064.member_1 * _e14379) + _e22064.member) * 6i)));
if ((_e22105 | _e22112) == 0u) {
} else {
let _e22188 = bitcast<u32>(_e22185);
if (_e22188 < _e269) {
let _e22192 = atomicAdd((&global_8.member[_e22188]), _e22105);
phi_56616_ = _e22192;
} else {
phi_56616_ = 0u;
}
let _e22194 = phi_56616_;
let _e22198 = (_e22112 + select(0u, 1u, ((_e22194 + _e22105) < _e22105)));
if (_e22198 == 0u) {
} else {
let _e22200 = (_e22188 + 1u);
if (_e22200 < _e269) {
let _e22204 = atomicAdd((&global_8.member[_e22200]), _e22198);
}
}
}
if ((_e22139 | _e22146) == 0u) {
} else {
let _e22208 = bitcast<u32>((_e22185 + 2i));
if (_e22208 < _e269) {
let _e22212 = atomicAdd((&global_8.member[_e22208]), _e22139);
phi_56646_ = _e22212;
} else {
phi_56646_ = 0u;
}
let _e22214 = phi_56646_;
let _e22218 = (_e22146 + select(0u, 1u, ((_e22214 + _e22139) < _e22139)));
if (_e22218 == 0u) {
} else {
let _e22220 = (_e22208 + 1u);
if (_e22220 < _e269) {
let _e22224 = atomicAdd((&global_8.member[_e22220]), _e22218);
}
}
}
if ((_e22173 | _e22180) == 0u) {
} else {
let _e22228 = bitcast<u32>((_e22185 + 4i));
if (_e22228 < _e269) {
let _e22232 = atomicAdd((&global_8.member[_e22228]), _e22173);
phi_56676_ = _e22232;
} else {
phi_56676_ = 0u;
}
let _e22234 = phi_56676_;
let _e22238 = (_e22180 + select(0u, 1u, ((_e22234 + _e22173) < _e22173)));
if (_e22238 == 0u) {
} else {
let _e22240 = (_e22228 + 1u);
if (_e22240 < _e269) {
let _e22244 = atomicAdd((&global_8.member[_e22240]), _e22238);
}
}
}
phi_53066_ = (_e20958 + 1i);
} else {
phi_53066_ = i32();
}
let _e22247 = phi_53066_;
continue;
continuing {
phi_53065_ = _e22247;
break if !(_e20961);
}
}
phi_52912_ = (_e20864 + 1i);
} else {
phi_52912_ = i32();
}
let _e22251 = phi_52912_;
continue;
continuing {
phi_52911_ = _e22251;
break if !(_e20865);
}
}
} else {
phi_56721_ = 0i;
loop {
let _e22254 = phi_56721_;
let _e22255 = (_e22254 < 16i);
if _e22255 {
let _e22257 = (_e14424 + (_e22254 & 15i));
let _e22259 = (f32(_e22257) + 0.5f);
let _e22261 = ((_e22259 * 1f) - 0.5f);
let _e22265 = (-(((_e415 * _e22261) + _e441)) / _e428);
let _e22272 = bitcast<f32>((bitcast<u32>(((_e465 * _e22261) + ((_e478 * _e22265) + _e491))) & 2147483647u));
let _e22279 = bitcast<f32>((bitcast<u32>(((_e504 * _e22261) + ((_e517 * _e22265) + _e530))) & 2147483647u));
let _e22283 = (((0.5f * (_e22272 + _e22279)) / _e533) + _e716);
let _e22284 = (1f / 1f);
let _e22292 = ((((_e22265 + _e22283) + 0.5f) * _e22284) - 0.5f);
let _e22293 = f32(_e20148);
let _e22294 = f32(_e20146);
let _e22295 = (_e22293 - 1f);
let _e22297 = select(_e22295, _e22292, (_e22292 > _e22295));
let _e22299 = select(_e22294, _e22297, (_e22297 < _e22294));
let _e22306 = select(0i, select(select(i32(_e22299), i32(-2147483648), (_e22299 < -2147483600f)), 2147483647i, (_e22299 > 2147483500f)), (_e22299 == _e22299));
let _e22311 = (((((_e22265 - _e22283) + 0.5f) * _e22284) - 0.5f) + 1f);
let _e22312 = (_e22294 + 1f);
let _e22314 = select(_e22293, _e22311, (_e22311 > _e22293));
let _e22316 = select(_e22312, _e22314, (_e22314 < _e22312));
let _e22323 = select(0i, select(select(i32(_e22316), i32(-2147483648), (_e22316 < -2147483600f)), 2147483647i, (_e22316 > 2147483500f)), (_e22316 == _e22316));
let _e22334 = ((1e-4f * 1f) * _e533);
let _e22336 = select(_e22279, _e22272, (_e22272 > _e22279));
let _e22338 = select(_e22334, _e22336, (_e22336 > _e22334));
let _e22340 = select(_e22279, _e22272, (_e22272 < _e22279));
let _e22342 = select(_e22334, _e22340, (_e22340 > _e22334));
let _e22344 = (0.5f * (_e22338 + _e22342));
let _e22345 = (0.5f / _e22342);
let _e22346 = (1f / _e22338);
phi_56875_ = 0i;
loop {
let _e22348 = phi_56875_;
let _e22350 = (((_e22323 - select(0i, 1i, (_e22316 < f32(_e22323)))) + (_e22254 >> bitcast<u32>(4u))) + bitcast<i32>(_e22348));
let _e22351 = (_e22350 <= select(-1i, (_e22306 - select(0i, 1i, (_e22299 < f32(_e22306)))), (_e22257 <= _e14428)));
if _e22351 {
let _e22353 = (f32(_e22350) + 0.5f);
let _e22357 = ((((_e22353 * 1f) - 0.5f) - _e22265) * _e533);
let _e22358 = (_e533 * 1f);
let _e22360 = (0.5f * _e22358);
let _e22361 = (_e22357 + _e22360);
let _e22362 = -(_e22361);
let _e22365 = (_e22344 - select(_e22362, _e22361, (_e22361 > _e22362)));
let _e22367 = select(0f, _e22365, (_e22365 > 0f));
let _e22369 = select(_e22342, _e22367, (_e22367 < _e22342));
let _e22372 = (_e22365 - _e22342);
let _e22376 = (((_e22369 * (_e22369 * _e22345)) + select(0f, _e22372, (_e22372 > 0f))) * _e22346);
let _e22380 = (_e22357 - _e22360);
let _e22381 = -(_e22380);
let _e22384 = (_e22344 - select(_e22381, _e22380, (_e22380 > _e22381)));
let _e22386 = select(0f, _e22384, (_e22384 > 0f));
let _e22388 = select(_e22342, _e22386, (_e22386 < _e22342));
let _e22391 = (_e22384 - _e22342);
let _e22395 = (((_e22388 * (_e22388 * _e22345)) + select(0f, _e22391, (_e22391 > 0f))) * _e22346);
if _e452 {
phi_56980_ = type_23(_e22350, _e22257);
} else {
phi_56980_ = type_23(_e22257, _e22350);
}
let _e22404 = phi_56980_;
local_24 = bitcast<i32>((_e14375 * _e14378));
local_25 = ((_e22404.member_1 * _e14379) + _e22404.member);
let _e22411 = local_24;
let _e22412 = local_25;
let _e22413 = (_e22411 + _e22412);
let _e22415 = (bitcast<i32>(_e258) - 1i);
let _e22417 = select(_e22415, _e22413, (_e22413 < _e22415));
let _e22422 = global_5.member[bitcast<u32>(select(0i, _e22417, (_e22417 > 0i)))];
let _e22423 = local_25;
let _e22425 = select(_e22415, _e22423, (_e22423 < _e22415));
let _e22430 = global_5.member[bitcast<u32>(select(0i, _e22425, (_e22425 > 0i)))];
let _e22433 = f32(_e14379);
let _e22434 = f32(_e14380);
let _e22441 = global_1.member.member_2.member;
let _e22442 = (((((f32(_e22404.member) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e22449 = global_1.member.member_2.member_1;
let _e22450 = ((1f - (((f32(_e22404.member_1) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e22452 = global_1.member.member_3;
let _e22460 = global_1.member.member_4;
let _e22467 = ((_e22452.member * _e22442) + (_e22460.member * _e22450));
let _e22468 = ((_e22452.member_1 * _e22442) + (_e22460.member_1 * _e22450));
let _e22469 = ((_e22452.member_2 * _e22442) + (_e22460.member_2 * _e22450));
let _e22472 = global_1.member.member_2.member_3;
let _e22473 = (_e22472 != 0u);
let _e22475 = global_1.member.member_5;
let _e22482 = select((_e22475.member + _e22467), _e22475.member, _e22473);
let _e22483 = select((_e22475.member_1 + _e22468), _e22475.member_1, _e22473);
let _e22484 = select((_e22475.member_2 + _e22469), _e22475.member_2, _e22473);
let _e22486 = global_1.member.member_6;
let _e22500 = (((_e22482 * _e22482) + (_e22483 * _e22483)) + (_e22484 * _e22484));
let _e22503 = sqrt(select(0f, _e22500, (_e22500 > 0f)));
let _e22504 = (1f / _e22503);
let _e22505 = (_e22482 * _e22504);
let _e22506 = (_e22483 * _e22504);
let _e22507 = (_e22484 * _e22504);
let _e22508 = (_e574 - select(_e22486.member, (_e22486.member + _e22467), _e22473));
let _e22509 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e22468), _e22473));
let _e22510 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e22469), _e22473));
let _e22515 = (((_e22508 * _e22505) + (_e22509 * _e22506)) + (_e22510 * _e22507));
let _e22520 = (((_e22508 * _e612) + (_e22509 * _e625)) + (_e22510 * _e638));
let _e22525 = (((_e22505 * _e612) + (_e22506 * _e625)) + (_e22507 * _e638));
let _e22528 = ((_e22506 * _e638) - (_e22507 * _e625));
let _e22531 = ((_e22507 * _e612) - (_e22505 * _e638));
let _e22534 = ((_e22505 * _e625) - (_e22506 * _e612));
let _e22539 = (((_e22528 * _e22528) + (_e22531 * _e22531)) + (_e22534 * _e22534));
let _e22542 = (1f / select(1e-9f, _e22539, (_e22539 > 1e-9f)));
let _e22545 = ((_e22515 - (_e22525 * _e22520)) * _e22542);
let _e22548 = (((_e22525 * _e22515) - _e22520) * _e22542);
let _e22554 = -(_e22525);
let _e22557 = global_1.member.member_13.member_2;
let _e22558 = (_e22557 * _e22557);
let _e22562 = ((1f + _e22558) - ((2f * _e22557) * _e22554));
let _e22564 = select(1e-9f, _e22562, (_e22562 > 1e-9f));
let _e22576 = global_1.member.member_13.member_3;
let _e22581 = (_e22503 * (select(((1f - _e22558) / (_e22564 * sqrt(select(0f, _e22564, (_e22564 > 0f))))), (0.75f * (1f + (_e22554 * _e22554))), (_e22576 == 1u)) * (0.25f / 3.1415927f)));
let _e22582 = (_e22545 - _e22422);
let _e22585 = (_e22548 + select(0f, _e22582, (_e22582 > 0f)));
let _e22588 = global_1.member.member_13.member_1;
let _e22597 = global_1.member.member_13.member;
let _e22602 = -((_e22597.member * _e22585));
let _e22604 = select(-87f, _e22602, (_e22602 > -87f));
let _e22606 = select(88f, _e22604, (_e22604 < 88f));
let _e22608 = ((_e22606 * 1.442695f) + 0.5f);
let _e22610 = select(-127f, _e22608, (_e22608 > -127f));
let _e22612 = select(128f, _e22610, (_e22610 < 128f));
let _e22619 = select(0i, select(select(i32(_e22612), i32(-2147483648), (_e22612 < -2147483600f)), 2147483647i, (_e22612 > 2147483500f)), (_e22612 == _e22612));
let _e22623 = (_e22619 - select(0i, 1i, (_e22612 < f32(_e22619))));
let _e22624 = f32(_e22623);
let _e22628 = ((_e22606 - (_e22624 * 0.6933594f)) - (_e22624 * -2.1219444e-4f));
let _e22650 = -((_e22597.member_1 * _e22585));
let _e22652 = select(-87f, _e22650, (_e22650 > -87f));
let _e22654 = select(88f, _e22652, (_e22652 < 88f));
let _e22656 = ((_e22654 * 1.442695f) + 0.5f);
let _e22658 = select(-127f, _e22656, (_e22656 > -127f));
let _e22660 = select(128f, _e22658, (_e22658 < 128f));
let _e22667 = select(0i, select(select(i32(_e22660), i32(-2147483648), (_e22660 < -2147483600f)), 2147483647i, (_e22660 > 2147483500f)), (_e22660 == _e22660));
let _e22671 = (_e22667 - select(0i, 1i, (_e22660 < f32(_e22667))));
let _e22672 = f32(_e22671);
let _e22676 = ((_e22654 - (_e22672 * 0.6933594f)) - (_e22672 * -2.1219444e-4f));
let _e22698 = -((_e22597.member_2 * _e22585));
let _e22700 = select(-87f, _e22698, (_e22698 > -87f));
let _e22702 = select(88f, _e22700, (_e22700 < 88f));
let _e22704 = ((_e22702 * 1.442695f) + 0.5f);
let _e22706 = select(-127f, _e22704, (_e22704 > -127f));
let _e22708 = select(128f, _e22706, (_e22706 < 128f));
let _e22715 = select(0i, select(select(i32(_e22708), i32(-2147483648), (_e22708 < -2147483600f)), 2147483647i, (_e22708 > 2147483500f)), (_e22708 == _e22708));
let _e22719 = (_e22715 - select(0i, 1i, (_e22708 < f32(_e22715))));
let _e22720 = f32(_e22719);
let _e22724 = ((_e22702 - (_e22720 * 0.6933594f)) - (_e22720 * -2.1219444e-4f));
let _e22751 = select(0f, _e22545, (((_e22548 >= 0f) && (_e22548 < _e690)) && (_e22545 > 0f)));
if _e452 {
phi_57556_ = type_23(_e19273, _e19272);
} else {
phi_57556_ = type_23(_e19272, _e19273);
}
let _e22755 = phi_57556_;
let _e22760 = f32((1i << bitcast<u32>(_e19261)));
let _e22761 = (1f / _e22760);
let _e22763 = ((_e22259 * _e22761) - 0.5f);
let _e22765 = ((_e22353 * _e22761) - 0.5f);
let _e22767 = select(-1f, _e22763, (_e22763 > -1f));
let _e22769 = select(1e6f, _e22767, (_e22767 < 1e6f));
let _e22776 = select(0i, select(select(i32(_e22769), i32(-2147483648), (_e22769 < -2147483600f)), 2147483647i, (_e22769 > 2147483500f)), (_e22769 == _e22769));
let _e22780 = (_e22776 - select(0i, 1i, (_e22769 < f32(_e22776))));
let _e22782 = select(-1f, _e22765, (_e22765 > -1f));
let _e22784 = select(1e6f, _e22782, (_e22782 < 1e6f));
let _e22791 = select(0i, select(select(i32(_e22784), i32(-2147483648), (_e22784 < -2147483600f)), 2147483647i, (_e22784 > 2147483500f)), (_e22784 == _e22784));
let _e22795 = (_e22791 - select(0i, 1i, (_e22784 < f32(_e22791))));
let _e22797 = (_e22763 - f32(_e22780));
let _e22799 = (_e22765 - f32(_e22795));
let _e22800 = (1f - _e22797);
let _e22801 = (1f - _e22799);
let _e22804 = select(_e22780, 0i, (_e22780 < 0i));
let _e22805 = (_e22804 >= _e22755.member);
if _e22805 {
phi_57634_ = (_e22755.member - 1i);
} else {
phi_57634_ = _e22804;
}
let _e22808 = phi_57634_;
let _e22810 = select(_e22795, 0i, (_e22795 < 0i));
let _e22811 = (_e22810 >= _e22755.member_1);
if _e22811 {
phi_57645_ = (_e22755.member_1 - 1i);
} else {
phi_57645_ = _e22810;
}
let _e22814 = phi_57645_;
let _e22818 = (((f32(_e22808) + 0.5f) * _e22760) - 0.5f);
let _e22822 = (((f32(_e22814) + 0.5f) * _e22760) - 0.5f);
if _e452 {
phi_57673_ = type_23(_e22814, _e22808);
} else {
phi_57673_ = type_23(_e22808, _e22814);
}
let _e22828 = phi_57673_;
let _e22834 = bitcast<i32>(((_e14375 + 1u) >> bitcast<u32>(1u)));
let _e22837 = global_1.member.member_18.member_6;
let _e22840 = global_1.member.member_18.member_7;
let _e22843 = global_1.member.member_18.member_8;
if _e14430 {
phi_57724_ = 0u;
} else {
if (_e765 == 1u) {
phi_57723_ = 0u;
} else {
if (_e765 == 2u) {
phi_57722_ = _e22837;
} else {
phi_57722_ = select(_e22843, _e22840, (_e765 == 3u));
}
let _e22849 = phi_57722_;
phi_57723_ = _e22849;
}
let _e22851 = phi_57723_;
phi_57724_ = _e22851;
}
let _e22853 = phi_57724_;
local_22 = (((bitcast<i32>(_e22853) + _e22828.member_1) * _e22834) + _e22828.member);
let _e22858 = local_22;
let _e22860 = (bitcast<i32>(_e261) - 1i);
let _e22862 = select(_e22860, _e22858, (_e22858 < _e22860));
let _e22867 = global_6.member[bitcast<u32>(select(0i, _e22862, (_e22862 > 0i)))];
let _e22872 = (((((select(_e22818, _e22822, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e22877 = ((1f - (((select(_e22822, _e22818, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e22884 = ((_e22452.member * _e22872) + (_e22460.member * _e22877));
let _e22885 = ((_e22452.member_1 * _e22872) + (_e22460.member_1 * _e22877));
let _e22886 = ((_e22452.member_2 * _e22872) + (_e22460.member_2 * _e22877));
let _e22890 = select((_e22475.member + _e22884), _e22475.member, _e22473);
let _e22891 = select((_e22475.member_1 + _e22885), _e22475.member_1, _e22473);
let _e22892 = select((_e22475.member_2 + _e22886), _e22475.member_2, _e22473);
let _e22903 = (((_e22890 * _e22890) + (_e22891 * _e22891)) + (_e22892 * _e22892));
let _e22907 = (1f / sqrt(select(0f, _e22903, (_e22903 > 0f))));
let _e22908 = (_e22890 * _e22907);
let _e22909 = (_e22891 * _e22907);
let _e22910 = (_e22892 * _e22907);
let _e22911 = (_e574 - select(_e22486.member, (_e22486.member + _e22884), _e22473));
let _e22912 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e22885), _e22473));
let _e22913 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e22886), _e22473));
let _e22918 = (((_e22911 * _e22908) + (_e22912 * _e22909)) + (_e22913 * _e22910));
let _e22923 = (((_e22911 * _e612) + (_e22912 * _e625)) + (_e22913 * _e638));
let _e22928 = (((_e22908 * _e612) + (_e22909 * _e625)) + (_e22910 * _e638));
let _e22931 = ((_e22909 * _e638) - (_e22910 * _e625));
let _e22934 = ((_e22910 * _e612) - (_e22908 * _e638));
let _e22937 = ((_e22908 * _e625) - (_e22909 * _e612));
let _e22942 = (((_e22931 * _e22931) + (_e22934 * _e22934)) + (_e22937 * _e22937));
let _e22945 = (1f / select(1e-9f, _e22942, (_e22942 > 1e-9f)));
let _e22948 = ((_e22918 - (_e22928 * _e22923)) * _e22945);
let _e22951 = (((_e22928 * _e22918) - _e22923) * _e22945);
let _e22957 = select(0f, _e22948, (((_e22951 >= 0f) && (_e22951 < _e690)) && (_e22948 > 0f)));
let _e22959 = (_e22808 << bitcast<u32>(_e19261));
let _e22971 = (_e22780 + 1i);
let _e22974 = select(_e22971, 0i, (_e22971 < 0i));
let _e22975 = (_e22974 >= _e22755.member);
if _e22975 {
phi_58271_ = (_e22755.member - 1i);
} else {
phi_58271_ = _e22974;
}
let _e22978 = phi_58271_;
if _e22811 {
phi_58282_ = (_e22755.member_1 - 1i);
} else {
phi_58282_ = _e22810;
}
let _e22981 = phi_58282_;
let _e22985 = (((f32(_e22978) + 0.5f) * _e22760) - 0.5f);
let _e22989 = (((f32(_e22981) + 0.5f) * _e22760) - 0.5f);
if _e452 {
phi_58310_ = type_23(_e22981, _e22978);
} else {
phi_58310_ = type_23(_e22978, _e22981);
}
let _e22995 = phi_58310_;
if _e14430 {
phi_58361_ = 0u;
} else {
if (_e765 == 1u) {
phi_58360_ = 0u;
} else {
if (_e765 == 2u) {
phi_58359_ = _e22837;
} else {
phi_58359_ = select(_e22843, _e22840, (_e765 == 3u));
}
let _e23003 = phi_58359_;
phi_58360_ = _e23003;
}
let _e23005 = phi_58360_;
phi_58361_ = _e23005;
}
let _e23007 = phi_58361_;
local_20 = (((bitcast<i32>(_e23007) + _e22995.member_1) * _e22834) + _e22995.member);
let _e23012 = local_20;
let _e23014 = select(_e22860, _e23012, (_e23012 < _e22860));
let _e23019 = global_6.member[bitcast<u32>(select(0i, _e23014, (_e23014 > 0i)))];
let _e23024 = (((((select(_e22985, _e22989, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23029 = ((1f - (((select(_e22989, _e22985, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23036 = ((_e22452.member * _e23024) + (_e22460.member * _e23029));
let _e23037 = ((_e22452.member_1 * _e23024) + (_e22460.member_1 * _e23029));
let _e23038 = ((_e22452.member_2 * _e23024) + (_e22460.member_2 * _e23029));
let _e23042 = select((_e22475.member + _e23036), _e22475.member, _e22473);
let _e23043 = select((_e22475.member_1 + _e23037), _e22475.member_1, _e22473);
let _e23044 = select((_e22475.member_2 + _e23038), _e22475.member_2, _e22473);
let _e23055 = (((_e23042 * _e23042) + (_e23043 * _e23043)) + (_e23044 * _e23044));
let _e23059 = (1f / sqrt(select(0f, _e23055, (_e23055 > 0f))));
let _e23060 = (_e23042 * _e23059);
let _e23061 = (_e23043 * _e23059);
let _e23062 = (_e23044 * _e23059);
let _e23063 = (_e574 - select(_e22486.member, (_e22486.member + _e23036), _e22473));
let _e23064 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23037), _e22473));
let _e23065 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23038), _e22473));
let _e23070 = (((_e23063 * _e23060) + (_e23064 * _e23061)) + (_e23065 * _e23062));
let _e23075 = (((_e23063 * _e612) + (_e23064 * _e625)) + (_e23065 * _e638));
let _e23080 = (((_e23060 * _e612) + (_e23061 * _e625)) + (_e23062 * _e638));
let _e23083 = ((_e23061 * _e638) - (_e23062 * _e625));
let _e23086 = ((_e23062 * _e612) - (_e23060 * _e638));
let _e23089 = ((_e23060 * _e625) - (_e23061 * _e612));
let _e23094 = (((_e23083 * _e23083) + (_e23086 * _e23086)) + (_e23089 * _e23089));
let _e23097 = (1f / select(1e-9f, _e23094, (_e23094 > 1e-9f)));
let _e23100 = ((_e23070 - (_e23080 * _e23075)) * _e23097);
let _e23103 = (((_e23080 * _e23070) - _e23075) * _e23097);
let _e23109 = select(0f, _e23100, (((_e23103 >= 0f) && (_e23103 < _e690)) && (_e23100 > 0f)));
let _e23111 = (_e22978 << bitcast<u32>(_e19261));
let _e23123 = (_e22795 + 1i);
if _e22805 {
phi_58908_ = (_e22755.member - 1i);
} else {
phi_58908_ = _e22804;
}
let _e23127 = phi_58908_;
let _e23129 = select(_e23123, 0i, (_e23123 < 0i));
let _e23130 = (_e23129 >= _e22755.member_1);
if _e23130 {
phi_58919_ = (_e22755.member_1 - 1i);
} else {
phi_58919_ = _e23129;
}
let _e23133 = phi_58919_;
let _e23137 = (((f32(_e23127) + 0.5f) * _e22760) - 0.5f);
let _e23141 = (((f32(_e23133) + 0.5f) * _e22760) - 0.5f);
if _e452 {
phi_58947_ = type_23(_e23133, _e23127);
} else {
phi_58947_ = type_23(_e23127, _e23133);
}
let _e23147 = phi_58947_;
if _e14430 {
phi_58998_ = 0u;
} else {
if (_e765 == 1u) {
phi_58997_ = 0u;
} else {
if (_e765 == 2u) {
phi_58996_ = _e22837;
} else {
phi_58996_ = select(_e22843, _e22840, (_e765 == 3u));
}
let _e23155 = phi_58996_;
phi_58997_ = _e23155;
}
let _e23157 = phi_58997_;
phi_58998_ = _e23157;
}
let _e23159 = phi_58998_;
local_18 = (((bitcast<i32>(_e23159) + _e23147.member_1) * _e22834) + _e23147.member);
let _e23164 = local_18;
let _e23166 = select(_e22860, _e23164, (_e23164 < _e22860));
let _e23171 = global_6.member[bitcast<u32>(select(0i, _e23166, (_e23166 > 0i)))];
let _e23176 = (((((select(_e23137, _e23141, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23181 = ((1f - (((select(_e23141, _e23137, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23188 = ((_e22452.member * _e23176) + (_e22460.member * _e23181));
let _e23189 = ((_e22452.member_1 * _e23176) + (_e22460.member_1 * _e23181));
let _e23190 = ((_e22452.member_2 * _e23176) + (_e22460.member_2 * _e23181));
let _e23194 = select((_e22475.member + _e23188), _e22475.member, _e22473);
let _e23195 = select((_e22475.member_1 + _e23189), _e22475.member_1, _e22473);
let _e23196 = select((_e22475.member_2 + _e23190), _e22475.member_2, _e22473);
let _e23207 = (((_e23194 * _e23194) + (_e23195 * _e23195)) + (_e23196 * _e23196));
let _e23211 = (1f / sqrt(select(0f, _e23207, (_e23207 > 0f))));
let _e23212 = (_e23194 * _e23211);
let _e23213 = (_e23195 * _e23211);
let _e23214 = (_e23196 * _e23211);
let _e23215 = (_e574 - select(_e22486.member, (_e22486.member + _e23188), _e22473));
let _e23216 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23189), _e22473));
let _e23217 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23190), _e22473));
let _e23222 = (((_e23215 * _e23212) + (_e23216 * _e23213)) + (_e23217 * _e23214));
let _e23227 = (((_e23215 * _e612) + (_e23216 * _e625)) + (_e23217 * _e638));
let _e23232 = (((_e23212 * _e612) + (_e23213 * _e625)) + (_e23214 * _e638));
let _e23235 = ((_e23213 * _e638) - (_e23214 * _e625));
let _e23238 = ((_e23214 * _e612) - (_e23212 * _e638));
let _e23241 = ((_e23212 * _e625) - (_e23213 * _e612));
let _e23246 = (((_e23235 * _e23235) + (_e23238 * _e23238)) + (_e23241 * _e23241));
let _e23249 = (1f / select(1e-9f, _e23246, (_e23246 > 1e-9f)));
let _e23252 = ((_e23222 - (_e23232 * _e23227)) * _e23249);
let _e23255 = (((_e23232 * _e23222) - _e23227) * _e23249);
let _e23261 = select(0f, _e23252, (((_e23255 >= 0f) && (_e23255 < _e690)) && (_e23252 > 0f)));
let _e23263 = (_e23127 << bitcast<u32>(_e19261));
if _e22975 {
phi_59545_ = (_e22755.member - 1i);
} else {
phi_59545_ = _e22974;
}
let _e23278 = phi_59545_;
if _e23130 {
phi_59556_ = (_e22755.member_1 - 1i);
} else {
phi_59556_ = _e23129;
}
let _e23281 = phi_59556_;
let _e23285 = (((f32(_e23278) + 0.5f) * _e22760) - 0.5f);
let _e23289 = (((f32(_e23281) + 0.5f) * _e22760) - 0.5f);
if _e452 {
phi_59584_ = type_23(_e23281, _e23278);
} else {
phi_59584_ = type_23(_e23278, _e23281);
}
let _e23295 = phi_59584_;
if _e14430 {
phi_59635_ = 0u;
} else {
if (_e765 == 1u) {
phi_59634_ = 0u;
} else {
if (_e765 == 2u) {
phi_59633_ = _e22837;
} else {
phi_59633_ = select(_e22843, _e22840, (_e765 == 3u));
}
let _e23303 = phi_59633_;
phi_59634_ = _e23303;
}
let _e23305 = phi_59634_;
phi_59635_ = _e23305;
}
let _e23307 = phi_59635_;
local_16 = (((bitcast<i32>(_e23307) + _e23295.member_1) * _e22834) + _e23295.member);
let _e23312 = local_16;
let _e23314 = select(_e22860, _e23312, (_e23312 < _e22860));
let _e23319 = global_6.member[bitcast<u32>(select(0i, _e23314, (_e23314 > 0i)))];
let _e23324 = (((((select(_e23285, _e23289, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23329 = ((1f - (((select(_e23289, _e23285, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23336 = ((_e22452.member * _e23324) + (_e22460.member * _e23329));
let _e23337 = ((_e22452.member_1 * _e23324) + (_e22460.member_1 * _e23329));
let _e23338 = ((_e22452.member_2 * _e23324) + (_e22460.member_2 * _e23329));
let _e23342 = select((_e22475.member + _e23336), _e22475.member, _e22473);
let _e23343 = select((_e22475.member_1 + _e23337), _e22475.member_1, _e22473);
let _e23344 = select((_e22475.member_2 + _e23338), _e22475.member_2, _e22473);
let _e23355 = (((_e23342 * _e23342) + (_e23343 * _e23343)) + (_e23344 * _e23344));
let _e23359 = (1f / sqrt(select(0f, _e23355, (_e23355 > 0f))));
let _e23360 = (_e23342 * _e23359);
let _e23361 = (_e23343 * _e23359);
let _e23362 = (_e23344 * _e23359);
let _e23363 = (_e574 - select(_e22486.member, (_e22486.member + _e23336), _e22473));
let _e23364 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23337), _e22473));
let _e23365 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23338), _e22473));
let _e23370 = (((_e23363 * _e23360) + (_e23364 * _e23361)) + (_e23365 * _e23362));
let _e23375 = (((_e23363 * _e612) + (_e23364 * _e625)) + (_e23365 * _e638));
let _e23380 = (((_e23360 * _e612) + (_e23361 * _e625)) + (_e23362 * _e638));
let _e23383 = ((_e23361 * _e638) - (_e23362 * _e625));
let _e23386 = ((_e23362 * _e612) - (_e23360 * _e638));
let _e23389 = ((_e23360 * _e625) - (_e23361 * _e612));
let _e23394 = (((_e23383 * _e23383) + (_e23386 * _e23386)) + (_e23389 * _e23389));
let _e23397 = (1f / select(1e-9f, _e23394, (_e23394 > 1e-9f)));
let _e23400 = ((_e23370 - (_e23380 * _e23375)) * _e23397);
let _e23403 = (((_e23380 * _e23370) - _e23375) * _e23397);
let _e23409 = select(0f, _e23400, (((_e23403 >= 0f) && (_e23403 < _e690)) && (_e23400 > 0f)));
let _e23411 = (_e23278 << bitcast<u32>(_e19261));
let _e23423 = select(((((1f - select(0f, (_e22800 * _e22801), (((select(select(_e765, _e926, (_e22959 >= _e691)), _e846, (_e22959 < _e297)) == _e765) && (_e22957 > 0f)) && (_e22957 < _e22867)))) - select(0f, (_e22797 * _e22801), (((select(select(_e765, _e926, (_e23111 >= _e691)), _e846, (_e23111 < _e297)) == _e765) && (_e23109 > 0f)) && (_e23109 < _e23019)))) - select(0f, (_e22800 * _e22799), (((select(select(_e765, _e926, (_e23263 >= _e691)), _e846, (_e23263 < _e297)) == _e765) && (_e23261 > 0f)) && (_e23261 < _e23171)))) - select(0f, (_e22797 * _e22799), (((select(select(_e765, _e926, (_e23411 >= _e691)), _e846, (_e23411 < _e297)) == _e765) && (_e23409 > 0f)) && (_e23409 < _e23319)))), 1f, _e14430);
let _e23424 = (_e20150 & 31u);
let _e23426 = (1u << bitcast<u32>(_e23424));
let _e23435 = bitcast<i32>((((_e14375 + _e23426) - 1u) >> bitcast<u32>(_e23424)));
let _e23436 = bitcast<i32>((((_e14378 + _e23426) - 1u) >> bitcast<u32>(_e23424)));
if _e452 {
phi_60200_ = type_23(_e23436, _e23435);
} else {
phi_60200_ = type_23(_e23435, _e23436);
}
let _e23440 = phi_60200_;
let _e23445 = f32((1i << bitcast<u32>(_e23424)));
let _e23446 = (1f / _e23445);
let _e23448 = ((_e22259 * _e23446) - 0.5f);
let _e23450 = ((_e22353 * _e23446) - 0.5f);
let _e23452 = select(-1f, _e23448, (_e23448 > -1f));
let _e23454 = select(1e6f, _e23452, (_e23452 < 1e6f));
let _e23461 = select(0i, select(select(i32(_e23454), i32(-2147483648), (_e23454 < -2147483600f)), 2147483647i, (_e23454 > 2147483500f)), (_e23454 == _e23454));
let _e23465 = (_e23461 - select(0i, 1i, (_e23454 < f32(_e23461))));
let _e23467 = select(-1f, _e23450, (_e23450 > -1f));
let _e23469 = select(1e6f, _e23467, (_e23467 < 1e6f));
let _e23476 = select(0i, select(select(i32(_e23469), i32(-2147483648), (_e23469 < -2147483600f)), 2147483647i, (_e23469 > 2147483500f)), (_e23469 == _e23469));
let _e23480 = (_e23476 - select(0i, 1i, (_e23469 < f32(_e23476))));
let _e23482 = (_e23448 - f32(_e23465));
let _e23484 = (_e23450 - f32(_e23480));
let _e23485 = (1f - _e23482);
let _e23486 = (1f - _e23484);
let _e23489 = select(_e23465, 0i, (_e23465 < 0i));
let _e23490 = (_e23489 >= _e23440.member);
if _e23490 {
phi_60278_ = (_e23440.member - 1i);
} else {
phi_60278_ = _e23489;
}
let _e23493 = phi_60278_;
let _e23495 = select(_e23480, 0i, (_e23480 < 0i));
let _e23496 = (_e23495 >= _e23440.member_1);
if _e23496 {
phi_60289_ = (_e23440.member_1 - 1i);
} else {
phi_60289_ = _e23495;
}
let _e23499 = phi_60289_;
let _e23503 = (((f32(_e23493) + 0.5f) * _e23445) - 0.5f);
let _e23507 = (((f32(_e23499) + 0.5f) * _e23445) - 0.5f);
if _e452 {
phi_60317_ = type_23(_e23499, _e23493);
} else {
phi_60317_ = type_23(_e23493, _e23499);
}
let _e23513 = phi_60317_;
let _e23516 = (_e20150 == 0u);
if _e23516 {
phi_60368_ = 0u;
} else {
if (_e20150 == 1u) {
phi_60367_ = 0u;
} else {
if (_e20150 == 2u) {
phi_60366_ = _e22837;
} else {
phi_60366_ = select(_e22843, _e22840, (_e20150 == 3u));
}
let _e23522 = phi_60366_;
phi_60367_ = _e23522;
}
let _e23524 = phi_60367_;
phi_60368_ = _e23524;
}
let _e23526 = phi_60368_;
local_14 = (((bitcast<i32>(_e23526) + _e23513.member_1) * _e22834) + _e23513.member);
let _e23531 = local_14;
let _e23533 = select(_e22860, _e23531, (_e23531 < _e22860));
let _e23538 = global_6.member[bitcast<u32>(select(0i, _e23533, (_e23533 > 0i)))];
let _e23543 = (((((select(_e23503, _e23507, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23548 = ((1f - (((select(_e23507, _e23503, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23555 = ((_e22452.member * _e23543) + (_e22460.member * _e23548));
let _e23556 = ((_e22452.member_1 * _e23543) + (_e22460.member_1 * _e23548));
let _e23557 = ((_e22452.member_2 * _e23543) + (_e22460.member_2 * _e23548));
let _e23561 = select((_e22475.member + _e23555), _e22475.member, _e22473);
let _e23562 = select((_e22475.member_1 + _e23556), _e22475.member_1, _e22473);
let _e23563 = select((_e22475.member_2 + _e23557), _e22475.member_2, _e22473);
let _e23574 = (((_e23561 * _e23561) + (_e23562 * _e23562)) + (_e23563 * _e23563));
let _e23578 = (1f / sqrt(select(0f, _e23574, (_e23574 > 0f))));
let _e23579 = (_e23561 * _e23578);
let _e23580 = (_e23562 * _e23578);
let _e23581 = (_e23563 * _e23578);
let _e23582 = (_e574 - select(_e22486.member, (_e22486.member + _e23555), _e22473));
let _e23583 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23556), _e22473));
let _e23584 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23557), _e22473));
let _e23589 = (((_e23582 * _e23579) + (_e23583 * _e23580)) + (_e23584 * _e23581));
let _e23594 = (((_e23582 * _e612) + (_e23583 * _e625)) + (_e23584 * _e638));
let _e23599 = (((_e23579 * _e612) + (_e23580 * _e625)) + (_e23581 * _e638));
let _e23602 = ((_e23580 * _e638) - (_e23581 * _e625));
let _e23605 = ((_e23581 * _e612) - (_e23579 * _e638));
let _e23608 = ((_e23579 * _e625) - (_e23580 * _e612));
let _e23613 = (((_e23602 * _e23602) + (_e23605 * _e23605)) + (_e23608 * _e23608));
let _e23616 = (1f / select(1e-9f, _e23613, (_e23613 > 1e-9f)));
let _e23619 = ((_e23589 - (_e23599 * _e23594)) * _e23616);
let _e23622 = (((_e23599 * _e23589) - _e23594) * _e23616);
let _e23628 = select(0f, _e23619, (((_e23622 >= 0f) && (_e23622 < _e690)) && (_e23619 > 0f)));
let _e23630 = (_e23493 << bitcast<u32>(_e23424));
let _e23642 = (_e23465 + 1i);
let _e23645 = select(_e23642, 0i, (_e23642 < 0i));
let _e23646 = (_e23645 >= _e23440.member);
if _e23646 {
phi_60915_ = (_e23440.member - 1i);
} else {
phi_60915_ = _e23645;
}
let _e23649 = phi_60915_;
if _e23496 {
phi_60926_ = (_e23440.member_1 - 1i);
} else {
phi_60926_ = _e23495;
}
let _e23652 = phi_60926_;
let _e23656 = (((f32(_e23649) + 0.5f) * _e23445) - 0.5f);
let _e23660 = (((f32(_e23652) + 0.5f) * _e23445) - 0.5f);
if _e452 {
phi_60954_ = type_23(_e23652, _e23649);
} else {
phi_60954_ = type_23(_e23649, _e23652);
}
let _e23666 = phi_60954_;
if _e23516 {
phi_61005_ = 0u;
} else {
if (_e20150 == 1u) {
phi_61004_ = 0u;
} else {
if (_e20150 == 2u) {
phi_61003_ = _e22837;
} else {
phi_61003_ = select(_e22843, _e22840, (_e20150 == 3u));
}
let _e23674 = phi_61003_;
phi_61004_ = _e23674;
}
let _e23676 = phi_61004_;
phi_61005_ = _e23676;
}
let _e23678 = phi_61005_;
local_12 = (((bitcast<i32>(_e23678) + _e23666.member_1) * _e22834) + _e23666.member);
let _e23683 = local_12;
let _e23685 = select(_e22860, _e23683, (_e23683 < _e22860));
let _e23690 = global_6.member[bitcast<u32>(select(0i, _e23685, (_e23685 > 0i)))];
let _e23695 = (((((select(_e23656, _e23660, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23700 = ((1f - (((select(_e23660, _e23656, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23707 = ((_e22452.member * _e23695) + (_e22460.member * _e23700));
let _e23708 = ((_e22452.member_1 * _e23695) + (_e22460.member_1 * _e23700));
let _e23709 = ((_e22452.member_2 * _e23695) + (_e22460.member_2 * _e23700));
let _e23713 = select((_e22475.member + _e23707), _e22475.member, _e22473);
let _e23714 = select((_e22475.member_1 + _e23708), _e22475.member_1, _e22473);
let _e23715 = select((_e22475.member_2 + _e23709), _e22475.member_2, _e22473);
let _e23726 = (((_e23713 * _e23713) + (_e23714 * _e23714)) + (_e23715 * _e23715));
let _e23730 = (1f / sqrt(select(0f, _e23726, (_e23726 > 0f))));
let _e23731 = (_e23713 * _e23730);
let _e23732 = (_e23714 * _e23730);
let _e23733 = (_e23715 * _e23730);
let _e23734 = (_e574 - select(_e22486.member, (_e22486.member + _e23707), _e22473));
let _e23735 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23708), _e22473));
let _e23736 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23709), _e22473));
let _e23741 = (((_e23734 * _e23731) + (_e23735 * _e23732)) + (_e23736 * _e23733));
let _e23746 = (((_e23734 * _e612) + (_e23735 * _e625)) + (_e23736 * _e638));
let _e23751 = (((_e23731 * _e612) + (_e23732 * _e625)) + (_e23733 * _e638));
let _e23754 = ((_e23732 * _e638) - (_e23733 * _e625));
let _e23757 = ((_e23733 * _e612) - (_e23731 * _e638));
let _e23760 = ((_e23731 * _e625) - (_e23732 * _e612));
let _e23765 = (((_e23754 * _e23754) + (_e23757 * _e23757)) + (_e23760 * _e23760));
let _e23768 = (1f / select(1e-9f, _e23765, (_e23765 > 1e-9f)));
let _e23771 = ((_e23741 - (_e23751 * _e23746)) * _e23768);
let _e23774 = (((_e23751 * _e23741) - _e23746) * _e23768);
let _e23780 = select(0f, _e23771, (((_e23774 >= 0f) && (_e23774 < _e690)) && (_e23771 > 0f)));
let _e23782 = (_e23649 << bitcast<u32>(_e23424));
let _e23794 = (_e23480 + 1i);
if _e23490 {
phi_61552_ = (_e23440.member - 1i);
} else {
phi_61552_ = _e23489;
}
let _e23798 = phi_61552_;
let _e23800 = select(_e23794, 0i, (_e23794 < 0i));
let _e23801 = (_e23800 >= _e23440.member_1);
if _e23801 {
phi_61563_ = (_e23440.member_1 - 1i);
} else {
phi_61563_ = _e23800;
}
let _e23804 = phi_61563_;
let _e23808 = (((f32(_e23798) + 0.5f) * _e23445) - 0.5f);
let _e23812 = (((f32(_e23804) + 0.5f) * _e23445) - 0.5f);
if _e452 {
phi_61591_ = type_23(_e23804, _e23798);
} else {
phi_61591_ = type_23(_e23798, _e23804);
}
let _e23818 = phi_61591_;
if _e23516 {
phi_61642_ = 0u;
} else {
if (_e20150 == 1u) {
phi_61641_ = 0u;
} else {
if (_e20150 == 2u) {
phi_61640_ = _e22837;
} else {
phi_61640_ = select(_e22843, _e22840, (_e20150 == 3u));
}
let _e23826 = phi_61640_;
phi_61641_ = _e23826;
}
let _e23828 = phi_61641_;
phi_61642_ = _e23828;
}
let _e23830 = phi_61642_;
local_10 = (((bitcast<i32>(_e23830) + _e23818.member_1) * _e22834) + _e23818.member);
let _e23835 = local_10;
let _e23837 = select(_e22860, _e23835, (_e23835 < _e22860));
let _e23842 = global_6.member[bitcast<u32>(select(0i, _e23837, (_e23837 > 0i)))];
let _e23847 = (((((select(_e23808, _e23812, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e23852 = ((1f - (((select(_e23812, _e23808, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e23859 = ((_e22452.member * _e23847) + (_e22460.member * _e23852));
let _e23860 = ((_e22452.member_1 * _e23847) + (_e22460.member_1 * _e23852));
let _e23861 = ((_e22452.member_2 * _e23847) + (_e22460.member_2 * _e23852));
let _e23865 = select((_e22475.member + _e23859), _e22475.member, _e22473);
let _e23866 = select((_e22475.member_1 + _e23860), _e22475.member_1, _e22473);
let _e23867 = select((_e22475.member_2 + _e23861), _e22475.member_2, _e22473);
let _e23878 = (((_e23865 * _e23865) + (_e23866 * _e23866)) + (_e23867 * _e23867));
let _e23882 = (1f / sqrt(select(0f, _e23878, (_e23878 > 0f))));
let _e23883 = (_e23865 * _e23882);
let _e23884 = (_e23866 * _e23882);
let _e23885 = (_e23867 * _e23882);
let _e23886 = (_e574 - select(_e22486.member, (_e22486.member + _e23859), _e22473));
let _e23887 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e23860), _e22473));
let _e23888 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e23861), _e22473));
let _e23893 = (((_e23886 * _e23883) + (_e23887 * _e23884)) + (_e23888 * _e23885));
let _e23898 = (((_e23886 * _e612) + (_e23887 * _e625)) + (_e23888 * _e638));
let _e23903 = (((_e23883 * _e612) + (_e23884 * _e625)) + (_e23885 * _e638));
let _e23906 = ((_e23884 * _e638) - (_e23885 * _e625));
let _e23909 = ((_e23885 * _e612) - (_e23883 * _e638));
let _e23912 = ((_e23883 * _e625) - (_e23884 * _e612));
let _e23917 = (((_e23906 * _e23906) + (_e23909 * _e23909)) + (_e23912 * _e23912));
let _e23920 = (1f / select(1e-9f, _e23917, (_e23917 > 1e-9f)));
let _e23923 = ((_e23893 - (_e23903 * _e23898)) * _e23920);
let _e23926 = (((_e23903 * _e23893) - _e23898) * _e23920);
let _e23932 = select(0f, _e23923, (((_e23926 >= 0f) && (_e23926 < _e690)) && (_e23923 > 0f)));
let _e23934 = (_e23798 << bitcast<u32>(_e23424));
if _e23646 {
phi_62189_ = (_e23440.member - 1i);
} else {
phi_62189_ = _e23645;
}
let _e23949 = phi_62189_;
if _e23801 {
phi_62200_ = (_e23440.member_1 - 1i);
} else {
phi_62200_ = _e23800;
}
let _e23952 = phi_62200_;
let _e23956 = (((f32(_e23949) + 0.5f) * _e23445) - 0.5f);
let _e23960 = (((f32(_e23952) + 0.5f) * _e23445) - 0.5f);
if _e452 {
phi_62228_ = type_23(_e23952, _e23949);
} else {
phi_62228_ = type_23(_e23949, _e23952);
}
let _e23966 = phi_62228_;
if _e23516 {
phi_62279_ = 0u;
} else {
if (_e20150 == 1u) {
phi_62278_ = 0u;
} else {
if (_e20150 == 2u) {
phi_62277_ = _e22837;
} else {
phi_62277_ = select(_e22843, _e22840, (_e20150 == 3u));
}
let _e23974 = phi_62277_;
phi_62278_ = _e23974;
}
let _e23976 = phi_62278_;
phi_62279_ = _e23976;
}
let _e23978 = phi_62279_;
local_8 = (((bitcast<i32>(_e23978) + _e23966.member_1) * _e22834) + _e23966.member);
let _e23983 = local_8;
let _e23985 = select(_e22860, _e23983, (_e23983 < _e22860));
let _e23990 = global_6.member[bitcast<u32>(select(0i, _e23985, (_e23985 > 0i)))];
let _e23995 = (((((select(_e23956, _e23960, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e24000 = ((1f - (((select(_e23960, _e23956, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e24007 = ((_e22452.member * _e23995) + (_e22460.member * _e24000));
let _e24008 = ((_e22452.member_1 * _e23995) + (_e22460.member_1 * _e24000));
let _e24009 = ((_e22452.member_2 * _e23995) + (_e22460.member_2 * _e24000));
let _e24013 = select((_e22475.member + _e24007), _e22475.member, _e22473);
let _e24014 = select((_e22475.member_1 + _e24008), _e22475.member_1, _e22473);
let _e24015 = select((_e22475.member_2 + _e24009), _e22475.member_2, _e22473);
let _e24026 = (((_e24013 * _e24013) + (_e24014 * _e24014)) + (_e24015 * _e24015));
let _e24030 = (1f / sqrt(select(0f, _e24026, (_e24026 > 0f))));
let _e24031 = (_e24013 * _e24030);
let _e24032 = (_e24014 * _e24030);
let _e24033 = (_e24015 * _e24030);
let _e24034 = (_e574 - select(_e22486.member, (_e22486.member + _e24007), _e22473));
let _e24035 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e24008), _e22473));
let _e24036 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e24009), _e22473));
let _e24041 = (((_e24034 * _e24031) + (_e24035 * _e24032)) + (_e24036 * _e24033));
let _e24046 = (((_e24034 * _e612) + (_e24035 * _e625)) + (_e24036 * _e638));
let _e24051 = (((_e24031 * _e612) + (_e24032 * _e625)) + (_e24033 * _e638));
let _e24054 = ((_e24032 * _e638) - (_e24033 * _e625));
let _e24057 = ((_e24033 * _e612) - (_e24031 * _e638));
let _e24060 = ((_e24031 * _e625) - (_e24032 * _e612));
let _e24065 = (((_e24054 * _e24054) + (_e24057 * _e24057)) + (_e24060 * _e24060));
let _e24068 = (1f / select(1e-9f, _e24065, (_e24065 > 1e-9f)));
let _e24071 = ((_e24041 - (_e24051 * _e24046)) * _e24068);
let _e24074 = (((_e24051 * _e24041) - _e24046) * _e24068);
let _e24080 = select(0f, _e24071, (((_e24074 >= 0f) && (_e24074 < _e690)) && (_e24071 > 0f)));
let _e24082 = (_e23949 << bitcast<u32>(_e23424));
let _e24094 = select(((((_e23423 - select(0f, (_e23485 * _e23486), (((select(select(_e765, _e926, (_e23630 >= _e691)), _e846, (_e23630 < _e297)) == _e20150) && (_e23628 > 0f)) && (_e23628 < _e23538)))) - select(0f, (_e23482 * _e23486), (((select(select(_e765, _e926, (_e23782 >= _e691)), _e846, (_e23782 < _e297)) == _e20150) && (_e23780 > 0f)) && (_e23780 < _e23690)))) - select(0f, (_e23485 * _e23484), (((select(select(_e765, _e926, (_e23934 >= _e691)), _e846, (_e23934 < _e297)) == _e20150) && (_e23932 > 0f)) && (_e23932 < _e23842)))) - select(0f, (_e23482 * _e23484), (((select(select(_e765, _e926, (_e24082 >= _e691)), _e846, (_e24082 < _e297)) == _e20150) && (_e24080 > 0f)) && (_e24080 < _e23990)))), _e23423, _e23516);
let _e24095 = (_e20154 & 31u);
let _e24097 = (1u << bitcast<u32>(_e24095));
let _e24106 = bitcast<i32>((((_e14375 + _e24097) - 1u) >> bitcast<u32>(_e24095)));
let _e24107 = bitcast<i32>((((_e14378 + _e24097) - 1u) >> bitcast<u32>(_e24095)));
if _e452 {
phi_62844_ = type_23(_e24107, _e24106);
} else {
phi_62844_ = type_23(_e24106, _e24107);
}
let _e24111 = phi_62844_;
let _e24116 = f32((1i << bitcast<u32>(_e24095)));
let _e24117 = (1f / _e24116);
let _e24119 = ((_e22259 * _e24117) - 0.5f);
let _e24121 = ((_e22353 * _e24117) - 0.5f);
let _e24123 = select(-1f, _e24119, (_e24119 > -1f));
let _e24125 = select(1e6f, _e24123, (_e24123 < 1e6f));
let _e24132 = select(0i, select(select(i32(_e24125), i32(-2147483648), (_e24125 < -2147483600f)), 2147483647i, (_e24125 > 2147483500f)), (_e24125 == _e24125));
let _e24136 = (_e24132 - select(0i, 1i, (_e24125 < f32(_e24132))));
let _e24138 = select(-1f, _e24121, (_e24121 > -1f));
let _e24140 = select(1e6f, _e24138, (_e24138 < 1e6f));
let _e24147 = select(0i, select(select(i32(_e24140), i32(-2147483648), (_e24140 < -2147483600f)), 2147483647i, (_e24140 > 2147483500f)), (_e24140 == _e24140));
let _e24151 = (_e24147 - select(0i, 1i, (_e24140 < f32(_e24147))));
let _e24153 = (_e24119 - f32(_e24136));
let _e24155 = (_e24121 - f32(_e24151));
let _e24156 = (1f - _e24153);
let _e24157 = (1f - _e24155);
let _e24160 = select(_e24136, 0i, (_e24136 < 0i));
let _e24161 = (_e24160 >= _e24111.member);
if _e24161 {
phi_62922_ = (_e24111.member - 1i);
} else {
phi_62922_ = _e24160;
}
let _e24164 = phi_62922_;
let _e24166 = select(_e24151, 0i, (_e24151 < 0i));
let _e24167 = (_e24166 >= _e24111.member_1);
if _e24167 {
phi_62933_ = (_e24111.member_1 - 1i);
} else {
phi_62933_ = _e24166;
}
let _e24170 = phi_62933_;
let _e24174 = (((f32(_e24164) + 0.5f) * _e24116) - 0.5f);
let _e24178 = (((f32(_e24170) + 0.5f) * _e24116) - 0.5f);
if _e452 {
phi_62961_ = type_23(_e24170, _e24164);
} else {
phi_62961_ = type_23(_e24164, _e24170);
}
let _e24184 = phi_62961_;
let _e24187 = (_e20154 == 0u);
if _e24187 {
phi_63012_ = 0u;
} else {
if (_e20154 == 1u) {
phi_63011_ = 0u;
} else {
if (_e20154 == 2u) {
phi_63010_ = _e22837;
} else {
phi_63010_ = select(_e22843, _e22840, (_e20154 == 3u));
}
let _e24193 = phi_63010_;
phi_63011_ = _e24193;
}
let _e24195 = phi_63011_;
phi_63012_ = _e24195;
}
let _e24197 = phi_63012_;
local_6 = (((bitcast<i32>(_e24197) + _e24184.member_1) * _e22834) + _e24184.member);
let _e24202 = local_6;
let _e24204 = select(_e22860, _e24202, (_e24202 < _e22860));
let _e24209 = global_6.member[bitcast<u32>(select(0i, _e24204, (_e24204 > 0i)))];
let _e24214 = (((((select(_e24174, _e24178, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e24219 = ((1f - (((select(_e24178, _e24174, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e24226 = ((_e22452.member * _e24214) + (_e22460.member * _e24219));
let _e24227 = ((_e22452.member_1 * _e24214) + (_e22460.member_1 * _e24219));
let _e24228 = ((_e22452.member_2 * _e24214) + (_e22460.member_2 * _e24219));
let _e24232 = select((_e22475.member + _e24226), _e22475.member, _e22473);
let _e24233 = select((_e22475.member_1 + _e24227), _e22475.member_1, _e22473);
let _e24234 = select((_e22475.member_2 + _e24228), _e22475.member_2, _e22473);
let _e24245 = (((_e24232 * _e24232) + (_e24233 * _e24233)) + (_e24234 * _e24234));
let _e24249 = (1f / sqrt(select(0f, _e24245, (_e24245 > 0f))));
let _e24250 = (_e24232 * _e24249);
let _e24251 = (_e24233 * _e24249);
let _e24252 = (_e24234 * _e24249);
let _e24253 = (_e574 - select(_e22486.member, (_e22486.member + _e24226), _e22473));
let _e24254 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e24227), _e22473));
let _e24255 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e24228), _e22473));
let _e24260 = (((_e24253 * _e24250) + (_e24254 * _e24251)) + (_e24255 * _e24252));
let _e24265 = (((_e24253 * _e612) + (_e24254 * _e625)) + (_e24255 * _e638));
let _e24270 = (((_e24250 * _e612) + (_e24251 * _e625)) + (_e24252 * _e638));
let _e24273 = ((_e24251 * _e638) - (_e24252 * _e625));
let _e24276 = ((_e24252 * _e612) - (_e24250 * _e638));
let _e24279 = ((_e24250 * _e625) - (_e24251 * _e612));
let _e24284 = (((_e24273 * _e24273) + (_e24276 * _e24276)) + (_e24279 * _e24279));
let _e24287 = (1f / select(1e-9f, _e24284, (_e24284 > 1e-9f)));
let _e24290 = ((_e24260 - (_e24270 * _e24265)) * _e24287);
let _e24293 = (((_e24270 * _e24260) - _e24265) * _e24287);
let _e24299 = select(0f, _e24290, (((_e24293 >= 0f) && (_e24293 < _e690)) && (_e24290 > 0f)));
let _e24301 = (_e24164 << bitcast<u32>(_e24095));
let _e24313 = (_e24136 + 1i);
let _e24316 = select(_e24313, 0i, (_e24313 < 0i));
let _e24317 = (_e24316 >= _e24111.member);
if _e24317 {
phi_63559_ = (_e24111.member - 1i);
} else {
phi_63559_ = _e24316;
}
let _e24320 = phi_63559_;
if _e24167 {
phi_63570_ = (_e24111.member_1 - 1i);
} else {
phi_63570_ = _e24166;
}
let _e24323 = phi_63570_;
let _e24327 = (((f32(_e24320) + 0.5f) * _e24116) - 0.5f);
let _e24331 = (((f32(_e24323) + 0.5f) * _e24116) - 0.5f);
if _e452 {
phi_63598_ = type_23(_e24323, _e24320);
} else {
phi_63598_ = type_23(_e24320, _e24323);
}
let _e24337 = phi_63598_;
if _e24187 {
phi_63649_ = 0u;
} else {
if (_e20154 == 1u) {
phi_63648_ = 0u;
} else {
if (_e20154 == 2u) {
phi_63647_ = _e22837;
} else {
phi_63647_ = select(_e22843, _e22840, (_e20154 == 3u));
}
let _e24345 = phi_63647_;
phi_63648_ = _e24345;
}
let _e24347 = phi_63648_;
phi_63649_ = _e24347;
}
let _e24349 = phi_63649_;
local_4 = (((bitcast<i32>(_e24349) + _e24337.member_1) * _e22834) + _e24337.member);
let _e24354 = local_4;
let _e24356 = select(_e22860, _e24354, (_e24354 < _e22860));
let _e24361 = global_6.member[bitcast<u32>(select(0i, _e24356, (_e24356 > 0i)))];
let _e24366 = (((((select(_e24327, _e24331, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e24371 = ((1f - (((select(_e24331, _e24327, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e24378 = ((_e22452.member * _e24366) + (_e22460.member * _e24371));
let _e24379 = ((_e22452.member_1 * _e24366) + (_e22460.member_1 * _e24371));
let _e24380 = ((_e22452.member_2 * _e24366) + (_e22460.member_2 * _e24371));
let _e24384 = select((_e22475.member + _e24378), _e22475.member, _e22473);
let _e24385 = select((_e22475.member_1 + _e24379), _e22475.member_1, _e22473);
let _e24386 = select((_e22475.member_2 + _e24380), _e22475.member_2, _e22473);
let _e24397 = (((_e24384 * _e24384) + (_e24385 * _e24385)) + (_e24386 * _e24386));
let _e24401 = (1f / sqrt(select(0f, _e24397, (_e24397 > 0f))));
let _e24402 = (_e24384 * _e24401);
let _e24403 = (_e24385 * _e24401);
let _e24404 = (_e24386 * _e24401);
let _e24405 = (_e574 - select(_e22486.member, (_e22486.member + _e24378), _e22473));
let _e24406 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e24379), _e22473));
let _e24407 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e24380), _e22473));
let _e24412 = (((_e24405 * _e24402) + (_e24406 * _e24403)) + (_e24407 * _e24404));
let _e24417 = (((_e24405 * _e612) + (_e24406 * _e625)) + (_e24407 * _e638));
let _e24422 = (((_e24402 * _e612) + (_e24403 * _e625)) + (_e24404 * _e638));
let _e24425 = ((_e24403 * _e638) - (_e24404 * _e625));
let _e24428 = ((_e24404 * _e612) - (_e24402 * _e638));
let _e24431 = ((_e24402 * _e625) - (_e24403 * _e612));
let _e24436 = (((_e24425 * _e24425) + (_e24428 * _e24428)) + (_e24431 * _e24431));
let _e24439 = (1f / select(1e-9f, _e24436, (_e24436 > 1e-9f)));
let _e24442 = ((_e24412 - (_e24422 * _e24417)) * _e24439);
let _e24445 = (((_e24422 * _e24412) - _e24417) * _e24439);
let _e24451 = select(0f, _e24442, (((_e24445 >= 0f) && (_e24445 < _e690)) && (_e24442 > 0f)));
let _e24453 = (_e24320 << bitcast<u32>(_e24095));
let _e24465 = (_e24151 + 1i);
if _e24161 {
phi_64196_ = (_e24111.member - 1i);
} else {
phi_64196_ = _e24160;
}
let _e24469 = phi_64196_;
let _e24471 = select(_e24465, 0i, (_e24465 < 0i));
let _e24472 = (_e24471 >= _e24111.member_1);
if _e24472 {
phi_64207_ = (_e24111.member_1 - 1i);
} else {
phi_64207_ = _e24471;
}
let _e24475 = phi_64207_;
let _e24479 = (((f32(_e24469) + 0.5f) * _e24116) - 0.5f);
let _e24483 = (((f32(_e24475) + 0.5f) * _e24116) - 0.5f);
if _e452 {
phi_64235_ = type_23(_e24475, _e24469);
} else {
phi_64235_ = type_23(_e24469, _e24475);
}
let _e24489 = phi_64235_;
if _e24187 {
phi_64286_ = 0u;
} else {
if (_e20154 == 1u) {
phi_64285_ = 0u;
} else {
if (_e20154 == 2u) {
phi_64284_ = _e22837;
} else {
phi_64284_ = select(_e22843, _e22840, (_e20154 == 3u));
}
let _e24497 = phi_64284_;
phi_64285_ = _e24497;
}
let _e24499 = phi_64285_;
phi_64286_ = _e24499;
}
let _e24501 = phi_64286_;
local_2 = (((bitcast<i32>(_e24501) + _e24489.member_1) * _e22834) + _e24489.member);
let _e24506 = local_2;
let _e24508 = select(_e22860, _e24506, (_e24506 < _e22860));
let _e24513 = global_6.member[bitcast<u32>(select(0i, _e24508, (_e24508 > 0i)))];
let _e24518 = (((((select(_e24479, _e24483, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e24523 = ((1f - (((select(_e24483, _e24479, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e24530 = ((_e22452.member * _e24518) + (_e22460.member * _e24523));
let _e24531 = ((_e22452.member_1 * _e24518) + (_e22460.member_1 * _e24523));
let _e24532 = ((_e22452.member_2 * _e24518) + (_e22460.member_2 * _e24523));
let _e24536 = select((_e22475.member + _e24530), _e22475.member, _e22473);
let _e24537 = select((_e22475.member_1 + _e24531), _e22475.member_1, _e22473);
let _e24538 = select((_e22475.member_2 + _e24532), _e22475.member_2, _e22473);
let _e24549 = (((_e24536 * _e24536) + (_e24537 * _e24537)) + (_e24538 * _e24538));
let _e24553 = (1f / sqrt(select(0f, _e24549, (_e24549 > 0f))));
let _e24554 = (_e24536 * _e24553);
let _e24555 = (_e24537 * _e24553);
let _e24556 = (_e24538 * _e24553);
let _e24557 = (_e574 - select(_e22486.member, (_e22486.member + _e24530), _e22473));
let _e24558 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e24531), _e22473));
let _e24559 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e24532), _e22473));
let _e24564 = (((_e24557 * _e24554) + (_e24558 * _e24555)) + (_e24559 * _e24556));
let _e24569 = (((_e24557 * _e612) + (_e24558 * _e625)) + (_e24559 * _e638));
let _e24574 = (((_e24554 * _e612) + (_e24555 * _e625)) + (_e24556 * _e638));
let _e24577 = ((_e24555 * _e638) - (_e24556 * _e625));
let _e24580 = ((_e24556 * _e612) - (_e24554 * _e638));
let _e24583 = ((_e24554 * _e625) - (_e24555 * _e612));
let _e24588 = (((_e24577 * _e24577) + (_e24580 * _e24580)) + (_e24583 * _e24583));
let _e24591 = (1f / select(1e-9f, _e24588, (_e24588 > 1e-9f)));
let _e24594 = ((_e24564 - (_e24574 * _e24569)) * _e24591);
let _e24597 = (((_e24574 * _e24564) - _e24569) * _e24591);
let _e24603 = select(0f, _e24594, (((_e24597 >= 0f) && (_e24597 < _e690)) && (_e24594 > 0f)));
let _e24605 = (_e24469 << bitcast<u32>(_e24095));
if _e24317 {
phi_64833_ = (_e24111.member - 1i);
} else {
phi_64833_ = _e24316;
}
let _e24620 = phi_64833_;
if _e24472 {
phi_64844_ = (_e24111.member_1 - 1i);
} else {
phi_64844_ = _e24471;
}
let _e24623 = phi_64844_;
let _e24627 = (((f32(_e24620) + 0.5f) * _e24116) - 0.5f);
let _e24631 = (((f32(_e24623) + 0.5f) * _e24116) - 0.5f);
if _e452 {
phi_64872_ = type_23(_e24623, _e24620);
} else {
phi_64872_ = type_23(_e24620, _e24623);
}
let _e24637 = phi_64872_;
if _e24187 {
phi_64923_ = 0u;
} else {
if (_e20154 == 1u) {
phi_64922_ = 0u;
} else {
if (_e20154 == 2u) {
phi_64921_ = _e22837;
} else {
phi_64921_ = select(_e22843, _e22840, (_e20154 == 3u));
}
let _e24645 = phi_64921_;
phi_64922_ = _e24645;
}
let _e24647 = phi_64922_;
phi_64923_ = _e24647;
}
let _e24649 = phi_64923_;
local = (((bitcast<i32>(_e24649) + _e24637.member_1) * _e22834) + _e24637.member);
let _e24654 = local;
let _e24656 = select(_e22860, _e24654, (_e24654 < _e22860));
let _e24661 = global_6.member[bitcast<u32>(select(0i, _e24656, (_e24656 > 0i)))];
let _e24666 = (((((select(_e24627, _e24631, _e452) + 0.5f) / _e22433) * 2f) - 1f) * _e22441);
let _e24671 = ((1f - (((select(_e24631, _e24627, _e452) + 0.5f) / _e22434) * 2f)) * _e22449);
let _e24678 = ((_e22452.member * _e24666) + (_e22460.member * _e24671));
let _e24679 = ((_e22452.member_1 * _e24666) + (_e22460.member_1 * _e24671));
let _e24680 = ((_e22452.member_2 * _e24666) + (_e22460.member_2 * _e24671));
let _e24684 = select((_e22475.member + _e24678), _e22475.member, _e22473);
let _e24685 = select((_e22475.member_1 + _e24679), _e22475.member_1, _e22473);
let _e24686 = select((_e22475.member_2 + _e24680), _e22475.member_2, _e22473);
let _e24697 = (((_e24684 * _e24684) + (_e24685 * _e24685)) + (_e24686 * _e24686));
let _e24701 = (1f / sqrt(select(0f, _e24697, (_e24697 > 0f))));
let _e24702 = (_e24684 * _e24701);
let _e24703 = (_e24685 * _e24701);
let _e24704 = (_e24686 * _e24701);
let _e24705 = (_e574 - select(_e22486.member, (_e22486.member + _e24678), _e22473));
let _e24706 = (_e586 - select(_e22486.member_1, (_e22486.member_1 + _e24679), _e22473));
let _e24707 = (_e599 - select(_e22486.member_2, (_e22486.member_2 + _e24680), _e22473));
let _e24712 = (((_e24705 * _e24702) + (_e24706 * _e24703)) + (_e24707 * _e24704));
let _e24717 = (((_e24705 * _e612) + (_e24706 * _e625)) + (_e24707 * _e638));
let _e24722 = (((_e24702 * _e612) + (_e24703 * _e625)) + (_e24704 * _e638));
let _e24725 = ((_e24703 * _e638) - (_e24704 * _e625));
let _e24728 = ((_e24704 * _e612) - (_e24702 * _e638));
let _e24731 = ((_e24702 * _e625) - (_e24703 * _e612));
let _e24736 = (((_e24725 * _e24725) + (_e24728 * _e24728)) + (_e24731 * _e24731));
let _e24739 = (1f / select(1e-9f, _e24736, (_e24736 > 1e-9f)));
let _e24742 = ((_e24712 - (_e24722 * _e24717)) * _e24739);
let _e24745 = (((_e24722 * _e24712) - _e24717) * _e24739);
let _e24751 = select(0f, _e24742, (((_e24745 >= 0f) && (_e24745 < _e690)) && (_e24742 > 0f)));
let _e24753 = (_e24620 << bitcast<u32>(_e24095));
let _e24765 = select(((((_e24094 - select(0f, (_e24156 * _e24157), (((select(select(_e765, _e926, (_e24301 >= _e691)), _e846, (_e24301 < _e297)) == _e20154) && (_e24299 > 0f)) && (_e24299 < _e24209)))) - select(0f, (_e24153 * _e24157), (((select(select(_e765, _e926, (_e24453 >= _e691)), _e846, (_e24453 < _e297)) == _e20154) && (_e24451 > 0f)) && (_e24451 < _e24361)))) - select(0f, (_e24156 * _e24155), (((select(select(_e765, _e926, (_e24605 >= _e691)), _e846, (_e24605 < _e297)) == _e20154) && (_e24603 > 0f)) && (_e24603 < _e24513)))) - select(0f, (_e24153 * _e24155), (((select(select(_e765, _e926, (_e24753 >= _e691)), _e846, (_e24753 < _e297)) == _e20154) && (_e24751 > 0f)) && (_e24751 < _e24661)))), _e24094, _e24187);
if _e452 {
phi_65479_ = type_23(_e22350, _e22257);
} else {
phi_65479_ = type_23(_e22257, _e22350);
}
let _e24780 = phi_65479_;
let _e24783 = (_e22351 && (((_e22751 > 0f) && (_e22751 < _e22430)) && (bitcast<f32>((bitcast<u32>(_e24765) & 2147483647u)) > 1e-6f)));
let _e24786 = global_1.member.member_18.member;
let _e24787 = (((select(_e22376, (1f - _e22376), (_e22361 >= 0f)) - select(_e22395, (1f - _e22395), (_e22380 >= 0f))) * (1f / _e22358)) * _e24786);
let _e24791 = select(0f, (((((_e651 * _e22588.member) * ((1f + (_e22628 * (1f + (_e22628 * (0.5f + (_e22628 * (0.16666667f + (_e22628 * (0.041666668f + (_e22628 * (0.008333334f + (_e22628 * (0.001388889f + (_e22628 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e22623 + 127i)) << bitcast<u32>(23i))))) * _e22581) * _e24765) * _e24787), _e24783);
let _e24792 = select(0f, (((((_e664 * _e22588.member_1) * ((1f + (_e22676 * (1f + (_e22676 * (0.5f + (_e22676 * (0.16666667f + (_e22676 * (0.041666668f + (_e22676 * (0.008333334f + (_e22676 * (0.001388889f + (_e22676 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e22671 + 127i)) << bitcast<u32>(23i))))) * _e22581) * _e24765) * _e24787), _e24783);
let _e24793 = select(0f, (((((_e677 * _e22588.member_2) * ((1f + (_e22724 * (1f + (_e22724 * (0.5f + (_e22724 * (0.16666667f + (_e22724 * (0.041666668f + (_e22724 * (0.008333334f + (_e22724 * (0.001388889f + (_e22724 * 1.984127e-4f)))))))))))))) * bitcast<f32>((bitcast<u32>((_e22719 + 127i)) << bitcast<u32>(23i))))) * _e22581) * _e24765) * _e24787), _e24783);
let _e24797 = (bitcast<f32>((bitcast<u32>(_e24791) & 2147483647u)) >= 1073741800f);
let _e24798 = (1f / 1048576f);
let _e24801 = ((_e24791 * select(1f, _e24798, _e24797)) + 0.5f);
let _e24803 = select(-1073741800f, _e24801, (_e24801 > -1073741800f));
let _e24805 = select(1073741800f, _e24803, (_e24803 < 1073741800f));
let _e24812 = select(0i, select(select(i32(_e24805), i32(-2147483648), (_e24805 < -2147483600f)), 2147483647i, (_e24805 > 2147483500f)), (_e24805 == _e24805));
let _e24816 = (_e24812 - select(0i, 1i, (_e24805 < f32(_e24812))));
let _e24817 = select(0i, 20i, _e24797);
let _e24821 = (bitcast<u32>(_e24816) << bitcast<u32>((_e24817 & 31i)));
let _e24828 = bitcast<u32>(((_e24816 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24817) & 31i))));
let _e24832 = (bitcast<f32>((bitcast<u32>(_e24792) & 2147483647u)) >= 1073741800f);
let _e24835 = ((_e24792 * select(1f, _e24798, _e24832)) + 0.5f);
let _e24837 = select(-1073741800f, _e24835, (_e24835 > -1073741800f));
let _e24839 = select(1073741800f, _e24837, (_e24837 < 1073741800f));
let _e24846 = select(0i, select(select(i32(_e24839), i32(-2147483648), (_e24839 < -2147483600f)), 2147483647i, (_e24839 > 2147483500f)), (_e24839 == _e24839));
let _e24850 = (_e24846 - select(0i, 1i, (_e24839 < f32(_e24846))));
let _e24851 = select(0i, 20i, _e24832);
let _e24855 = (bitcast<u32>(_e24850) << bitcast<u32>((_e24851 & 31i)));
let _e24862 = bitcast<u32>(((_e24850 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24851) & 31i))));
let _e24866 = (bitcast<f32>((bitcast<u32>(_e24793) & 2147483647u)) >= 1073741800f);
let _e24869 = ((_e24793 * select(1f, _e24798, _e24866)) + 0.5f);
let _e24871 = select(-1073741800f, _e24869, (_e24869 > -1073741800f));
let _e24873 = select(1073741800f, _e24871, (_e24871 < 1073741800f));
let _e24880 = select(0i, select(select(i32(_e24873), i32(-2147483648), (_e24873 < -2147483600f)), 2147483647i, (_e24873 > 2147483500f)), (_e24873 == _e24873));
let _e24884 = (_e24880 - select(0i, 1i, (_e24873 < f32(_e24880))));
let _e24885 = select(0i, 20i, _e24866);
let _e24889 = (bitcast<u32>(_e24884) << bitcast<u32>((_e24885 & 31i)));
let _e24896 = bitcast<u32>(((_e24884 >> bitcast<u32>(1i)) >> bitcast<u32>(((31i - _e24885) & 31i))));
let _e24901 = bitcast<i32>(bitcast<u32>((((_e24780.member_1 * _e14379) + _e24780.member) * 6i)));
if ((_e24821 | _e24828) == 0u) {
} else {
let _e24904 = bitcast<u32>(_e24901);
if (_e24904 < _e269) {
let _e24908 = atomicAdd((&global_8.member[_e24904]), _e24821);
phi_65712_ = _e24908;
} else {
phi_65712_ = 0u;
}
let _e24910 = phi_65712_;
let _e24914 = (_e24828 + select(0u, 1u, ((_e24910 + _e24821) < _e24821)));
if (_e24914 == 0u) {
} else {
let _e24916 = (_e24904 + 1u);
if (_e24916 < _e269) {
let _e24920 = atomicAdd((&global_8.member[_e24916]), _e24914);
}
}
}
if ((_e24855 | _e24862) == 0u) {
} else {
let _e24924 = bitcast<u32>((_e24901 + 2i));
if (_e24924 < _e269) {
let _e24928 = atomicAdd((&global_8.member[_e24924]), _e24855);
phi_65742_ = _e24928;
} else {
phi_65742_ = 0u;
}
let _e24930 = phi_65742_;
let _e24934 = (_e24862 + select(0u, 1u, ((_e24930 + _e24855) < _e24855)));
if (_e24934 == 0u) {
} else {
let _e24936 = (_e24924 + 1u);
if (_e24936 < _e269) {
let _e24940 = atomicAdd((&global_8.member[_e24936]), _e24934);
}
}
}
if ((_e24889 | _e24896) == 0u) {
} else {
let _e24944 = bitcast<u32>((_e24901 + 4i));
if (_e24944 < _e269) {
let _e24948 = atomicAdd((&global_8.member[_e24944]), _e24889);
phi_65772_ = _e24948;
} else {
phi_65772_ = 0u;
}
let _e24950 = phi_65772_;
let _e24954 = (_e24896 + select(0u, 1u, ((_e24950 + _e24889) < _e24889)));
if (_e24954 == 0u) {
} else {
let _e24956 = (_e24944 + 1u);
if (_e24956 < _e269) {
let _e24960 = atomicAdd((&global_8.member[_e24956]), _e24954);
}
}
}
phi_56876_ = (_e22348 + 1i);
} else {
phi_56876_ = i32();
}
let _e24963 = phi_56876_;
continue;
continuing {
phi_56875_ = _e24963;
break if !(_e22351);
}
}
phi_56722_ = (_e22254 + 1i);
} else {
phi_56722_ = i32();
}
let _e24967 = phi_56722_;
continue;
continuing {
phi_56721_ = _e24967;
break if !(_e22255);
}
}
}
}
}
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
